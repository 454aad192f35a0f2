#include "MeshForPoints.h"

#include "BoundaryCorners.h"
#include "BoundarySingularities.h"
#include "ConfigurationSymmetry.h"
#include "DomainQueries.h"
#include "DrillHoles.h"
#include "LoopArc.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Minimum number of edges across narrow parts: with two, vertices are inside every part, so that a
/// seam can pass through it.
constexpr double EdgesAcross = 2.0;

/// Returns size sources that refine the mesh at each singularity.
std::vector<SizeSource> RefinementSources(
  const Configuration& configuration, const PlanarDomain& domain, double size)
{
  std::vector<SizeSource> sources;
  for (const Singularity& singularity : configuration)
  {
    if (!singularity.position.allFinite())
    {
      continue; // refused by SolveHField
    }
    double spacing = std::abs(SignedDistance(singularity.position, domain));
    spacing = spacing <= BoundaryReach * domain.Diagonal() ? size : std::min(spacing, size);
    for (const Singularity& other : configuration)
    {
      const double apart = (other.position - singularity.position).norm();
      spacing = apart > 0.0 ? std::min(spacing, apart) : spacing;
    }
    // A thousandth is fine enough for any picture and bounds the number of triangles.
    sources.push_back({ singularity.position, std::max(0.25 * spacing, 1e-3 * size) });
  }
  return sources;
}

/// Returns options that refine the mesh at each singularity of each configuration.
DrillOptions RefineAt(
  const std::vector<Configuration>& configurations, const PlanarDomain& domain, double meshSize)
{
  DrillOptions options;
  options.meshSize = meshSize;
  options.edgesAcross = EdgesAcross;
  const double size = ResolveMeshSize(options, domain);
  for (const Configuration& configuration : configurations)
  {
    const std::vector<SizeSource> sources = RefinementSources(configuration, domain, size);
    options.refinements.insert(options.refinements.end(), sources.begin(), sources.end());
  }
  return options;
}

/// Returns those of given vertices that are on straight sides, which symmetries of a domain ignore.
std::vector<Point> OnStraightSides(const PlanarDomain& domain, const std::vector<Point>& vertices)
{
  std::vector<Point> straight;
  for (const Loop& loop : domain.loops)
  {
    const std::vector<double> turns = LoopArc(loop).Turns();
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      if (std::abs(turns[i]) <= AngleRounding &&
        std::find(vertices.begin(), vertices.end(), loop[i]) != vertices.end())
      {
        straight.push_back(loop[i]);
      }
    }
  }
  return straight;
}
}

TriangleMesh MeshForPoints(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize, const Progress& progress)
{
  return MeshForConfigurations(domain, { configuration }, meshSize, progress);
}

TriangleMesh MeshThroughPoints(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize, const Progress& progress, double refinement, const std::vector<Point>& kept)
{
  DrillOptions options = RefineAt({ configuration }, domain, meshSize);
  options.refinement = refinement;
  const double reach = SymmetryReach * domain.Diagonal();
  const std::vector<Point> straight = OnStraightSides(domain, kept);
  const auto keepsStraight = [&](const Isometry& symmetry)
  {
    return std::all_of(straight.begin(), straight.end(),
      [&](const Point& point)
      {
        return std::any_of(straight.begin(), straight.end(),
          [&](const Point& other) { return (symmetry(point) - other).norm() <= reach; });
      });
  };
  options.symmetries =
    MatchSymmetry(configuration, FindSymmetries(domain), reach, keepsStraight).group;
  for (const Singularity& singularity : configuration)
  {
    // Singularities on the boundary become vertices of it; SolveSeamlessMap refuses those outside.
    if (singularity.position.allFinite() &&
      SignedDistance(singularity.position, domain) > BoundaryReach * domain.Diagonal())
    {
      options.vertices.push_back(singularity.position);
    }
  }
  return DrillHoles(InsertBoundarySingularities(domain, configuration), {}, options, progress);
}

TriangleMesh MeshForConfigurations(const PlanarDomain& domain,
  const std::vector<Configuration>& configurations, double meshSize, const Progress& progress)
{
  Configuration all;
  for (const Configuration& configuration : configurations)
  {
    all.insert(all.end(), configuration.begin(), configuration.end());
  }
  return DrillHoles(InsertBoundarySingularities(domain, all), {},
    RefineAt(configurations, domain, meshSize), progress);
}
}
