#include "CrossDirection.h"

#include <Eigen/LU>

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Returns the angle of a cross of the map at a point: the direction in which u grows.
double CrossAngleAt(const SeamlessMap& map, const Point& place)
{
  const PlanarTopology& topology = *RequirePlanar(map.topology);
  std::size_t nearest = 0;
  double largest = 0.0; // minimum barycentric coordinate, not positive in other triangles
  for (std::size_t t = 0; t < topology.mesh.triangles.size(); ++t)
  {
    const auto& v = topology.mesh.triangles[t];
    const Point& a = topology.PointAt(v[0]);
    const Point& b = topology.PointAt(v[1]);
    const Point& c = topology.PointAt(v[2]);
    const double area = Cross(b - a, c - a);
    const double inside =
      std::min({ Cross(c - b, place - b), Cross(a - c, place - c), Cross(b - a, place - a) }) /
      area;
    if (t == 0 || inside > largest)
    {
      nearest = t;
      largest = inside;
    }
  }
  const auto& v = topology.mesh.triangles[nearest];
  const auto triangle = static_cast<int>(nearest);
  Eigen::Matrix2d plane;
  plane << topology.PointAt(v[1]) - topology.PointAt(v[0]),
    topology.PointAt(v[2]) - topology.PointAt(v[0]);
  Eigen::Matrix2d chart;
  chart << map.At(triangle, 1) - map.At(triangle, 0), map.At(triangle, 2) - map.At(triangle, 0);
  const Point direction = plane * chart.inverse() * Point(1.0, 0.0);
  return std::atan2(direction.y(), direction.x());
}
}

std::vector<double> CrossAnglesAt(const SeamlessMap& map, const std::vector<Point>& places)
{
  std::vector<double> angles;
  std::transform(places.begin(), places.end(), std::back_inserter(angles),
    [&map](const Point& place) { return CrossAngleAt(map, place); });
  return angles;
}
}
