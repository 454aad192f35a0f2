#pragma once

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

namespace crossfield
{
using Point = Eigen::Vector2d;
/// A closed polygon: the last point is joined to the first, none is repeated.
using Loop = std::vector<Point>;

constexpr double Pi = 3.14159265358979323846;

/// z component of a × b.
inline double Cross(const Point& a, const Point& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Angle from a to b in (−π, π], counter-clockwise positive.
inline double AngleBetween(const Point& a, const Point& b)
{
  return std::atan2(Cross(a, b), a.dot(b));
}

/// The angle modulo 2π in (−π, π].
double WrapAngle(double angle);

/// "(x, y)", for messages.
std::string Describe(const Point& point);

/// Area enclosed by a loop, positive when it is counter-clockwise.
double SignedArea(const Loop& loop);

/// Length of the diagonal of the bounding box of some points; the size that tolerances refer to.
double BoundingDiagonal(const std::vector<Loop>& loops);
}
