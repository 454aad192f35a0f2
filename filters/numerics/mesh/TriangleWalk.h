#pragma once

#include "Plane.h"

#include <array>

namespace crossfield
{
/// Where a straight path leaves a triangle.
struct PathExit
{
  int side = -1;         ///< −1 if the path ends in the triangle.
  double fraction = 2.0; ///< Part of the path that lies in the triangle.
};

/// Returns the side of a counter-clockwise triangle that a straight path from a point in it meets first. It is not
/// the side by which it `entered`, −1 if it starts there.
PathExit FindExit(
  const std::array<Point, 3>& triangle, const Point& from, const Point& to, int entered);

/// Returns the barycentric coordinates of a point; for one outside, those of a point of the outline.
std::array<double, 3> WeightsAt(const std::array<Point, 3>& triangle, const Point& point);
}
