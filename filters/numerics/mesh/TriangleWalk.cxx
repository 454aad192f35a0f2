#include "TriangleWalk.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Returns twice the area that a point spans with each side of a triangle: barycentric coordinates
/// up to a factor.
std::array<double, 3> AreasAt(const std::array<Point, 3>& triangle, const Point& point)
{
  std::array<double, 3> areas{};
  for (std::size_t side = 0; side < 3; ++side)
  {
    areas[side] = Cross(triangle[(side + 1) % 3] - triangle[side], point - triangle[side]);
  }
  return areas;
}
}

PathExit FindExit(
  const std::array<Point, 3>& triangle, const Point& from, const Point& to, int entered)
{
  const std::array<double, 3> start = AreasAt(triangle, from);
  const std::array<double, 3> end = AreasAt(triangle, to);
  PathExit exit;
  for (int side = 0; side < 3; ++side)
  {
    if (side != entered && end[side] < 0.0)
    {
      const double inside = std::max(0.0, start[side]);
      const double at = inside / (inside - end[side]);
      if (at < exit.fraction)
      {
        exit = { side, at };
      }
    }
  }
  return exit;
}

std::array<double, 3> WeightsAt(const std::array<Point, 3>& triangle, const Point& point)
{
  // Corner i is opposite to side i + 1.
  const std::array<double, 3> areas = AreasAt(triangle, point);
  std::array<double, 3> weights{};
  double sum = 0.0;
  for (std::size_t side = 0; side < 3; ++side)
  {
    weights[(side + 2) % 3] = std::max(0.0, areas[side]);
    sum += std::max(0.0, areas[side]);
  }
  for (double& weight : weights)
  {
    weight /= sum;
  }
  return weights;
}
}
