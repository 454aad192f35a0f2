#include "ChartWalk.h"

#include "Error.h"
#include "TriangleArea.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Returns twice the area that a point spans with each side of a triangle: barycentric coordinates
/// up to a factor.
std::array<double, 3> AreasAt(const SeamlessMap& map, int triangle, const Point& w)
{
  std::array<double, 3> areas{};
  for (int side = 0; side < 3; ++side)
  {
    const Point& from = map.At(triangle, side);
    areas[side] = Cross(map.At(triangle, (side + 1) % 3) - from, w - from);
  }
  return areas;
}
}

ChartPlace WalkStraight(const SeamlessMap& map, ChartPlace place, const Point& displacement)
{
  Point target = place.w + TurnByQuarters(displacement, place.rotation);
  int entered = -1;
  // A straight path meets every triangle a few times at most.
  for (std::size_t step = 0; step <= 4 * map.corners.size(); ++step)
  {
    const std::array<double, 3> start = AreasAt(map, place.triangle, place.w);
    const std::array<double, 3> end = AreasAt(map, place.triangle, target);
    int side = -1;
    double first = 2.0;
    for (int i = 0; i < 3; ++i)
    {
      if (i != entered && end[i] < 0.0)
      {
        const double inside = std::max(0.0, start[i]);
        const double at = inside / (inside - end[i]);
        if (at < first)
        {
          first = at;
          side = i;
        }
      }
    }
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
