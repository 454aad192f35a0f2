#include "FieldConfiguration.h"

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
#include <utility>

namespace crossfield
{
namespace
{
/// Enough for the places of a start, and a few tenths of a second.
constexpr double Triangles = 5000.0;

double CoarseSize(const PlanarDomain& domain)
{
  return std::sqrt(4.0 / std::sqrt(3.0) * domain.Area() / Triangles); // equilateral ones
}

/// The half of the way to the nearest other one, at most the distance to the boundary.
double RoomAt(const PlanarDomain& domain, const Point& place, const Configuration& others)
{
  double room = SignedDistance(place, domain);
  for (const Singularity& other : others)
  {
    room = std::min(room, 0.5 * (other.position - place).norm());
  }
  return room;
}

/// Adds a singularity at the place that is nearest to where it was and has the wanted room, or else at
/// the one with the most, on rings of up to four times that. Leaves it out where there is none.
void AddWithRoom(
  const PlanarDomain& domain, Singularity singularity, double wanted, Configuration& result)
{
  constexpr int Rings = 16;
  constexpr int Directions = 32;
  const Point centre = singularity.position;
  double most = 0.0;
  for (int ring = 0; ring <= Rings && most < 0.95 * wanted; ++ring)
  {
    const double radius = 0.25 * wanted * ring;
    for (int i = 0; i < (ring == 0 ? 1 : Directions); ++i)
    {
      const double angle = 2.0 * Pi * i / Directions;
      const Point place = centre + radius * Point(std::cos(angle), std::sin(angle));
      const double room = std::min(wanted, RoomAt(domain, place, result));
      // By more than rounding, so that mirrored domains are not decided by it.
      if (room > most * (1.0 + 1e-9))
      {
        most = room;
        singularity.position = place;
      }
    }
  }
  if (most > 0.0)
  {
    result.push_back(singularity);
  }
}

/// Singularities of ±1 that stand for one quarter index, all at its place.
void AddUnits(const Point& place, int quarterIndex, Configuration& result)
{
  for (int i = 0; i < std::abs(quarterIndex); ++i)
  {
    result.push_back({ place, quarterIndex > 0 ? 1 : -1, 0.0 });
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
  // Every side has a triangle of its size, and more up to the size of the others.
  const bool fine = static_cast<double>(sides) > 0.5 * Triangles;
  const SharedTopology topology = ShareTopology(DrillHoles(
    fine ? CoarsenBoundary(domain, drill.meshSize, options.cornerAngle, options.corners) : domain,
    {}, drill, progress.Part(0.0, 0.2)));
  GinzburgLandauOptions solve;
  solve.epsilon = drill.meshSize;
  // Singularities rest long before the field does: they are wanted within an edge, and a start need not
  // be a minimum.
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
  const MeshTopology& topology = *field.topology;
  const PoincareHopfCount count =
    CountQuarters(topology.AlignedLoops(), 0, options.cornerAngle, options.corners);

  // 1. What the field shows, corners apart.
  FieldSingularityOptions reading;
  reading.corners = true;
  reading.cornerAngle = options.cornerAngle;
  for (const CountedCorner& corner : count.corners)
  {
    reading.chosenVertices.push_back(topology.VertexOf(corner));
  }
  Configuration seen;
  std::vector<int> ofCorner(count.corners.size(), 0);
  for (const FieldSingularity& singularity : FindFieldSingularities(field, reading))
  {
    const auto corner = std::find_if(count.corners.begin(), count.corners.end(),
      [&](const CountedCorner& candidate)
      { return topology.VertexOf(candidate) == singularity.vertex; });
    if (corner != count.corners.end())
    {
      ofCorner[static_cast<std::size_t>(corner - count.corners.begin())] = singularity.quarterIndex;
    }
    else
    {
      AddUnits(singularity.position, singularity.quarterIndex, seen);
    }
  }
  // 2. What the corners are counted with otherwise goes inside.
  for (std::size_t i = 0; i < count.corners.size(); ++i)
  {
    const CountedCorner& corner = count.corners[i];
    if (ofCorner[i] != corner.quarterIndex)
    {
      result.otherCorners.push_back({ corner.position, ofCorner[i] });
      AddUnits(corner.position, ofCorner[i] - corner.quarterIndex, seen);
    }
  }
  // 3. To places where a mesh can tell them from the boundary and from each other.
  CancelOpposites(seen, 3.0 * coarse.meshSize);
  const double wanted = coarse.meshSize; // nearer ones the mesh would not tell apart
  for (const Singularity& singularity : seen)
  {
    AddWithRoom(domain, singularity, wanted, result.singularities);
  }
  // 4. Some may have found no room.
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
