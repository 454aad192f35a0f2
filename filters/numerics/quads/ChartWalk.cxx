#include "ChartWalk.h"

#include "Error.h"
#include "TriangleArea.h"
#include "TriangleWalk.h"

#include <cmath>

namespace crossfield
{
ChartPlace WalkStraight(const SeamlessMap& map, ChartPlace place, const Point& displacement)
{
  Point target = place.w + TurnByQuarters(displacement, place.rotation);
  int entered = -1;
  // A straight path meets every triangle a few times at most.
  for (std::size_t step = 0; step <= 4 * map.corners.size(); ++step)
  {
    const std::array<Point, 3> triangle = { map.At(place.triangle, 0), map.At(place.triangle, 1),
      map.At(place.triangle, 2) };
    const int side = FindExit(triangle, place.w, target, entered).side;
    const int next = side < 0 ? -1 : map.topology->Neighbour(place.triangle, side);
    if (next < 0)
    {
      place.w = target;
      return place;
    }
    if (map.seams[place.triangle][side] != 0)
    {
      const SeamTransition across = map.Across(place.triangle, side);
      place.w = across(place.w);
      target = across(target);
      place.rotation = (place.rotation + across.rotation) % 4;
    }
    entered = map.topology->SideOf(next, map.topology->EdgeOf(place.triangle, side));
    place.triangle = next;
  }
  throw Error("A straight path in the seamless map does not end near " +
    map.topology->Where(map.topology->mesh.triangles[place.triangle][0]) + "; use a finer mesh.");
}

double PlaneScale(const SeamlessMap& map, int triangle)
{
  const double flat = TriangleArea(map.At(triangle, 0), map.At(triangle, 1), map.At(triangle, 2));
  return std::sqrt(map.topology->AreaOf(triangle) / flat);
}
}
