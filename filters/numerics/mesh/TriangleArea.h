#pragma once

#include "TriangleMesh.h"

namespace crossfield
{
/// Returns the signed area of a triangle, positive if its corners are counter-clockwise.
inline double TriangleArea(const Point& a, const Point& b, const Point& c)
{
  return 0.5 * Cross(b - a, c - a);
}
inline double TriangleArea(const std::vector<Point>& points, const std::array<int, 3>& triangle)
{
  return TriangleArea(points[triangle[0]], points[triangle[1]], points[triangle[2]]);
}
inline double TriangleArea(const TriangleMesh& mesh, const std::array<int, 3>& triangle)
{
  return TriangleArea(mesh.points, triangle);
}
}
