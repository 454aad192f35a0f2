#include "FieldConfiguration.h"

#include "CanonicalFrame.h"
#include "CoarseBoundary.h"
#include "ConfigurationPairs.h"
#include "ConfigurationSpread.h"
#include "DomainQueries.h"
#include "DrillHoles.h"
#include "FieldSingularities.h"
#include "GinzburgLandau.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
/// Number of triangles: sufficient for starting positions, and a few tenths of a second.
constexpr double TriangleCount = 5000.0;

double CoarseSize(const PlanarDomain& domain)
{
  return std::sqrt(
    4.0 / std::sqrt(3.0) * domain.Area() / TriangleCount); // for equilateral triangles
}

/// Returns the distance to the boundary or half of the distance to the nearest other singularity,
/// whichever is smaller.
double ClearanceAt(const PlanarDomain& domain, const Point& position, const Configuration& others)
{
  double clearance = SignedDistance(position, domain);
  for (const Singularity& other : others)
  {
    clearance = std::min(clearance, 0.5 * (other.position - position).norm());
  }
  return clearance;
}

/// Adds a singularity at the position closest to its original one that has the target clearance,
/// otherwise at the position with the largest clearance, searching on rings with radii of up to
/// four times the target. Adds nothing if no position is inside.
void AddWithClearance(
  const PlanarDomain& domain, Singularity singularity, double target, Configuration& result)
{
  constexpr int Rings = 16;
  constexpr int Directions = 32;
  const Point centre = singularity.position;
  const double first = CanonicalFrame(domain.loops).GetAngle();
  double largest = 0.0;
  for (int ring = 0; ring <= Rings && largest < 0.95 * target; ++ring)
  {
    const double radius = 0.25 * target * ring;
    for (int i = 0; i < (ring == 0 ? 1 : Directions); ++i)
    {
      const double angle = first + 2.0 * Pi * i / Directions;
      const Point position = centre + radius * Point(std::cos(angle), std::sin(angle));
      const double clearance = std::min(target, ClearanceAt(domain, position, result));
      // The difference must exceed rounding, so that it does not decide on mirrored domains.
      if (clearance > largest * (1.0 + 1e-9))
      {
        largest = clearance;
        singularity.position = position;
      }
    }
  }
  // Closer to the boundary it would be a singularity of the boundary: in a thin corner, none of the
  // directions need lead inside.
  if (largest > BoundaryReach * domain.Diagonal())
  {
    result.push_back(singularity);
  }
}

/// Adds singularities of ±1 with a given sum, all at one position.
void AddUnits(const Point& position, int quarterIndex, Configuration& result)
{
  for (int i = 0; i < std::abs(quarterIndex); ++i)
  {
    result.push_back({ position, quarterIndex > 0 ? 1 : -1, 0.0 });
  }
}
}

CoarseField SolveCoarseField(
  const PlanarDomain& domain, const FieldConfigurationOptions& options, const Progress& progress)
{
  DrillOptions drill;
  drill.meshSize = CoarseSize(domain);
  std::size_t sides = 0;
  for (const Loop& loop : domain.loops)
  {
    sides += loop.size();
  }
  // Each side has a triangle of its size, and more triangles up to the size of the others.
  const bool isDetailed = static_cast<double>(sides) > 0.5 * TriangleCount;
  const SharedPlanarTopology topology = ShareTopology(DrillHoles(isDetailed
      ? CoarsenBoundary(domain, drill.meshSize, options.cornerAngle, options.corners)
      : domain,
    {}, drill, progress.Part(0.0, 0.2)));
  GinzburgLandauOptions solve;
  solve.epsilon = drill.meshSize;
  // Singularities are stationary long before the field has converged; their positions are needed to
  // an edge only, and a start need not be a minimum.
  solve.tolerance = 1e-3;
  solve.maximumIterations = 30;
  GinzburgLandauField field = SolveGinzburgLandau(topology, solve, progress.Part(0.2, 1.0));
  return { std::move(static_cast<CrossField&>(field)), drill.meshSize };
}

FieldConfiguration ReadConfiguration(
  const PlanarDomain& domain, const CoarseField& coarse, const FieldConfigurationOptions& options)
{
  FieldConfiguration result;
  const CrossField& field = coarse.field;
  const PlanarTopology& topology = *field.topology;
  const PoincareHopfCount count =
    CountQuarters(topology.AlignedLoops(), 0, options.cornerAngle, options.corners);

  // 1. Read the indices of corners and the singularities of the field.
  FieldSingularityOptions reading;
  reading.corners = true;
  reading.cornerAngle = options.cornerAngle;
  for (const CountedCorner& corner : count.corners)
  {
    reading.chosenVertices.push_back(topology.VertexOf(corner));
  }
  Configuration found;
  std::vector<int> fieldIndices(count.corners.size(), 0);
  for (const FieldSingularity& singularity : FindFieldSingularities(field, reading))
  {
    const auto corner = std::find_if(count.corners.begin(), count.corners.end(),
      [&](const CountedCorner& candidate)
      { return topology.VertexOf(candidate) == singularity.vertex; });
    if (corner != count.corners.end())
    {
      fieldIndices[corner - count.corners.begin()] = singularity.quarterIndex;
    }
    else
    {
      AddUnits(singularity.position, singularity.quarterIndex, found);
    }
  }
  // 2. Place the differences between the indices of corners in the field and the prescribed ones
  // inside, except opposite ones at ties: rounding decided about these in the field, and the boundary is smooth there.
  Configuration ties;
  for (std::size_t i = 0; i < count.corners.size(); ++i)
  {
    const CountedCorner& corner = count.corners[i];
    if (fieldIndices[i] != corner.quarterIndex)
    {
      result.otherCorners.push_back({ corner.position, fieldIndices[i] });
      const bool isTie = !corner.chosen && IsTie(corner.Turning());
      AddUnits(corner.position, fieldIndices[i] - corner.quarterIndex, isTie ? ties : found);
    }
  }
  CancelOpposites(ties, std::numeric_limits<double>::infinity());
  found.insert(found.end(), ties.begin(), ties.end());
  // 3. Move singularities to positions that a mesh can distinguish from the boundary and from each
  // other.
  CancelOpposites(found, 3.0 * coarse.meshSize);
  const double target = coarse.meshSize; // the mesh does not resolve smaller distances
  for (const Singularity& singularity : found)
  {
    AddWithClearance(domain, singularity, target, result.singularities);
  }
  // 4. Complete the sum if there was no space for some of them.
  if (TotalQuarters(result.singularities) != count.requiredInteriorQuarters)
  {
    SpreadOptions spread;
    spread.cornerAngle = options.cornerAngle;
    spread.corners = options.corners;
    spread.given = result.singularities;
    result.singularities = SpreadConfiguration(domain, spread);
  }
  return result;
}
}
