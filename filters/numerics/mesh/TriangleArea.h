#pragma once

#include "TriangleMesh.h"

namespace crossfield
{
/// Returns the signed area of a triangle, positive if its corners are counter-clockwise.
inline double TriangleArea(const std::vector<Point>& points, const std::array<int, 3>& triangle)
{
  const Point& origin = points[static_cast<std::size_t>(triangle[0])];
  return 0.5 *
    Cross(points[static_cast<std::size_t>(triangle[1])] - origin,
      points[static_cast<std::size_t>(triangle[2])] - origin);
}
inline double TriangleArea(const TriangleMesh& mesh, const std::array<int, 3>& triangle)
{
  return TriangleArea(mesh.points, triangle);
}
}
