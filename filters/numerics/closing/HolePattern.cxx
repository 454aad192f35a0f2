#include "HolePattern.h"

#include "DomainQueries.h"
#include "Index.h"

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
  const MeshTopology& topology = *map.topology;
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

std::vector<RoundHole> FindRoundHoles(const PlanarDomain& domain)
{
  constexpr std::size_t FewestVertices = 12;
  constexpr double Tolerance = 0.01; // relative to the radius
  std::vector<RoundHole> holes;
  for (std::size_t l = 1; l < domain.loops.size(); ++l)
  {
    const Loop& loop = domain.loops[l];
    RoundHole hole;
    hole.loop = l;
    double length = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point& next = loop[(i + 1) % loop.size()];
      const double edge = (next - loop[i]).norm();
      hole.centre += 0.5 * edge * (loop[i] + next);
      length += edge;
    }
    hole.centre /= length;
    const auto distance = [&](const Point& point) { return (point - hole.centre).norm(); };
    const auto [nearest, farthest] = std::minmax_element(loop.begin(), loop.end(),
      [&](const Point& a, const Point& b) { return distance(a) < distance(b); });
    hole.radius = distance(*farthest);
    if (loop.size() >= FewestVertices && distance(*nearest) > (1.0 - Tolerance) * hole.radius)
    {
      PlanarDomain others = domain;
      others.loops.erase(others.loops.begin() + static_cast<std::ptrdiff_t>(l));
      hole.gap = SignedDistance(hole.centre, others) - hole.radius;
      holes.push_back(hole);
    }
  }
  return holes;
}

PlanarDomain FillHoles(const PlanarDomain& domain, const std::vector<RoundHole>& holes)
{
  PlanarDomain filled = domain;
  for (auto hole = holes.rbegin(); hole != holes.rend(); ++hole)
  {
    filled.loops.erase(filled.loops.begin() + static_cast<std::ptrdiff_t>(hole->loop));
  }
  return filled;
}

Configuration PatternAroundHoles(const std::vector<RoundHole>& holes, const SeamlessMap& filled)
{
  // √2 radii are the corners of the square around a circle.
  constexpr double RelativeDistance = 1.41;
  constexpr double GapFraction = 0.4;
  Configuration pattern;
  for (const RoundHole& hole : holes)
  {
    const double distance =
      std::min(RelativeDistance * hole.radius, hole.radius + GapFraction * hole.gap);
    const double angle = CrossAngleAt(filled, hole.centre) + 0.25 * Pi;
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      const double turned = angle + 0.5 * Pi * quarter;
      pattern.push_back({ hole.centre + distance * Point(std::cos(turned), std::sin(turned)), -1 });
    }
  }
  return pattern;
}
}
