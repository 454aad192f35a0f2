#include "PoincareHopf.h"

#include "Error.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace crossfield
{
PoincareHopfCount CountQuarters(
  const std::vector<Loop>& loops, int givenInteriorQuarters, double cornerAngle)
{
  PoincareHopfCount count;
  count.eulerCharacteristic = 2 - static_cast<int>(loops.size());
  count.givenInteriorQuarters = givenInteriorQuarters;
  double corners = 0.0;
  double curves = 0.0;
  for (const Loop& loop : loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point& here = loop[i];
      const Point before = here - loop[(i + loop.size() - 1) % loop.size()];
      const Point after = loop[(i + 1) % loop.size()] - here;
      const double turning = AngleBetween(before, after);
      if (std::abs(turning) > cornerAngle)
      {
        corners += SmallestRotation(turning);
      }
      else
      {
        curves += turning;
      }
    }
  }
  count.valence = corners / (2.0 * Pi);
  count.tangentTurning = curves / (2.0 * Pi);
  count.requiredInteriorQuarters =
    static_cast<int>(std::lround(4.0 * (count.valence + count.tangentTurning)));
  return count;
}

double SmallestRotation(double turning)
{
  double rotation = std::remainder(turning, 0.5 * Pi);
  // An angle of exactly π/4 may come out of the coordinates' rounding on either side.
  constexpr double Rounding = 1e-9;
  if (rotation < -0.25 * Pi + Rounding)
  {
    rotation += 0.5 * Pi;
  }
  return rotation;
}

PoincareHopfCount CountMeshQuarters(
  const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops)
{
  std::vector<Loop> aligned;
  int given = 0;
  for (const BoundaryLoop& loop : loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      given += loop.quarterIndex;
      continue;
    }
    aligned.emplace_back();
    for (int edge : loop.edges)
    {
      const int start = mesh.boundary[static_cast<std::size_t>(edge)].vertices[0];
      aligned.back().push_back(mesh.points[static_cast<std::size_t>(start)]);
    }
    if (loop.kind == BoundaryKind::Inner)
    {
      // BoundaryLoop runs counter-clockwise around the island, the domain is then on the right.
      std::reverse(aligned.back().begin(), aligned.back().end());
    }
  }
  return CountQuarters(aligned, given);
}

void RequireConsistent(const PoincareHopfCount& count)
{
  if (!count.Consistent())
  {
    const int missing = count.requiredInteriorQuarters - count.givenInteriorQuarters;
    throw Error("The quarter indices of the singularities add up to " +
      std::to_string(count.givenInteriorQuarters) + " but the Poincaré-Hopf theorem asks for " +
      std::to_string(count.requiredInteriorQuarters) + " on this domain; add singularities of total " +
        std::to_string(missing) + ".",
      Error::Kind::Inconsistent);
  }
}
}
