#include "ConfigurationPlacement.h"

#include "CornerClassification.h"
#include "DomainQueries.h"
#include "DrillHoles.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Nearer to the boundary than this part of the diagonal is on it, as in MatchChoices.
constexpr double BoundaryReach = 1e-6;
}

PlacedConfiguration PlaceConfiguration(const TriangleMesh& mesh,
  const std::vector<BoundaryLoop>& loops, const Configuration& configuration,
  const std::vector<CornerChoice>& corners)
{
  PlacedConfiguration placed;
  placed.corners = corners;
  const PlanarDomain domain{ AlignedLoops(mesh, loops) };
  const double reach = BoundaryReach * domain.Diagonal();
  for (std::size_t row = 0; row < configuration.size(); ++row)
  {
    const Singularity& singularity = configuration[row];
    const bool atVertex = std::any_of(domain.loops.begin(), domain.loops.end(),
      [&](const Loop& loop)
      {
        return std::any_of(loop.begin(), loop.end(),
          [&](const Point& point) { return (point - singularity.position).norm() <= reach; });
      });
    if (atVertex)
    {
      placed.corners.push_back({ singularity.position, singularity.quarterIndex });
    }
    else
    {
      placed.interior.push_back(singularity);
      placed.rows.push_back(row);
    }
  }
  PoincareHopfCount count = CountMeshQuarters(mesh, loops, placed.corners);
  const bool holes = std::any_of(loops.begin(), loops.end(),
    [](const BoundaryLoop& loop) { return loop.kind == BoundaryKind::Hole; });
  const int interior = holes ? count.givenInteriorQuarters : TotalQuarters(placed.interior);
  count.givenInteriorQuarters = interior;
  if (count.Consistent())
  {
    return placed;
  }
  // The smallest rotations do not fit: the cheapest assignment around what was given.
  ClassificationOptions options;
  const std::vector<Corner> all = FindCorners(domain.loops);
  const auto isAt = [reach](const Point& position)
  {
    return [&position, reach](const auto& other)
    { return (other.position - position).norm() <= reach; };
  };
  for (const CornerChoice& choice : placed.corners)
  {
    if (std::any_of(all.begin(), all.end(), isAt(choice.position)))
    {
      options.overrides.push_back(choice);
    }
  }
  if (!all.empty())
  {
    std::vector<CornerChoice> completed = placed.corners;
    for (const ClassifiedCorner& corner : ClassifyCorners(domain, options).corners)
    {
      if (!corner.overridden)
      {
        completed.push_back({ corner.position, corner.quarterIndex });
      }
    }
    PoincareHopfCount other = CountMeshQuarters(mesh, loops, completed);
    other.givenInteriorQuarters = interior;
    if (other.Consistent())
    {
      placed.corners = completed;
      return placed;
    }
  }
  RequireConsistent(count);
  return placed;
}

PlanarDomain InsertBoundarySingularities(
  const PlanarDomain& domain, const Configuration& configuration)
{
  PlanarDomain result = domain;
  const double reach = BoundaryReach * domain.Diagonal();
  for (const Singularity& singularity : configuration)
  {
    const Point& place = singularity.position;
    for (Loop& loop : result.loops)
    {
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const Point& from = loop[i];
        const Point along = loop[(i + 1) % loop.size()] - from;
        const double t = (place - from).dot(along) / along.squaredNorm();
        const double end = reach / along.norm();
        if (t > end && t < 1.0 - end && (from + t * along - place).norm() <= reach)
        {
          loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, from + t * along);
          break;
        }
      }
    }
  }
  return result;
}

TriangleMesh MeshForPoints(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize, const Progress& progress)
{
  DrillOptions options;
  options.meshSize = meshSize;
  const double size = ResolveMeshSize(options, domain);
  for (const Singularity& singularity : configuration)
  {
    if (!singularity.position.allFinite())
    {
      continue; // SolveHField refuses it
    }
    double room = std::abs(SignedDistance(singularity.position, domain));
    room = room <= BoundaryReach * domain.Diagonal() ? size : std::min(room, size);
    for (const Singularity& other : configuration)
    {
      const double apart = (other.position - singularity.position).norm();
      room = apart > 0.0 ? std::min(room, apart) : room;
    }
    // A thousandth is fine enough for any picture, and bounds the number of triangles.
    options.refinements.push_back({ singularity.position, std::max(0.25 * room, 1e-3 * size) });
  }
  return DrillHoles(InsertBoundarySingularities(domain, configuration), {}, options, progress);
}
}
