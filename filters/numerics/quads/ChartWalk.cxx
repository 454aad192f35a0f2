#include "ChartWalk.h"

#include "Error.h"
#include "Index.h"

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
    areas[Index(side)] = Cross(map.At(triangle, (side + 1) % 3) - from, w - from);
  }
  return areas;
}
}

ChartPlace WalkStraight(const SeamlessMap& map, ChartPlace place, const Point& displacement)
{
  const EdgeNumbering& edges = map.topology->edges;
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
      if (i != entered && end[Index(i)] < 0.0)
      {
        const double inside = std::max(0.0, start[Index(i)]);
        const double at = inside / (inside - end[Index(i)]);
        if (at < first)
        {
          first = at;
          side = i;
        }
      }
    }
    const int edge = side < 0 ? -1 : edges.ofTriangle[Index(place.triangle)][Index(side)];
    const int next = side < 0                             ? -1
      : edges.triangles[Index(edge)][0] == place.triangle ? edges.triangles[Index(edge)][1]
                                                          : edges.triangles[Index(edge)][0];
    if (next < 0)
    {
      place.w = target;
      return place;
    }
    if (map.seams[Index(place.triangle)][Index(side)] != 0)
    {
      const SeamTransition across = map.Across(place.triangle, side);
      place.w = across(place.w);
      target = across(target);
      place.rotation = (place.rotation + across.rotation) % 4;
    }
    place.triangle = next;
    const auto& sides = edges.ofTriangle[Index(next)];
    entered = static_cast<int>(std::find(sides.begin(), sides.end(), edge) - sides.begin());
  }
  throw Error("A straight path in the seamless map does not end near " +
    Describe(PlanePoint(map, place)) + "; use a finer mesh.");
}

Point PlanePoint(const SeamlessMap& map, const ChartPlace& place)
{
  // Corner i is opposite to side i + 1.
  std::array<double, 3> areas = AreasAt(map, place.triangle, place.w);
  double sum = 0.0;
  for (double& area : areas)
  {
    area = std::max(0.0, area);
    sum += area;
  }
  Point point = Point::Zero();
  const auto& vertices = map.topology->mesh.triangles[Index(place.triangle)];
  for (std::size_t i = 0; i < 3; ++i)
  {
    point += (areas[(i + 1) % 3] / sum) * map.topology->PointAt(vertices[i]);
  }
  return point;
}

double PlaneScale(const SeamlessMap& map, int triangle)
{
  const auto& v = map.topology->mesh.triangles[Index(triangle)];
  const Point& origin = map.topology->PointAt(v[0]);
  const double plane =
    Cross(map.topology->PointAt(v[1]) - origin, map.topology->PointAt(v[2]) - origin);
  const double flat =
    Cross(map.At(triangle, 1) - map.At(triangle, 0), map.At(triangle, 2) - map.At(triangle, 0));
  return std::sqrt(plane / flat);
}
}
