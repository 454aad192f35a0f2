#pragma once

#include <Eigen/Core>

#include <cmath>
#include <string>
#include <vector>

namespace crossfield
{
using Point = Eigen::Vector2d;
using SpacePoint = Eigen::Vector3d; ///< In the plane, z is 0.
/// Closed polygon; the last point is joined to the first, and no point is repeated.
using Loop = std::vector<Point>;

constexpr double Pi = 3.14159265358979323846;

/// Tolerance of angles in radians: smaller differences are rounding errors of the coordinates.
constexpr double AngleRounding = 1e-9;

/// Returns a point of the plane z = 0.
inline SpacePoint InSpace(const Point& point)
{
  return { point.x(), point.y(), 0.0 };
}

/// Returns points of the plane z = 0.
std::vector<SpacePoint> InSpace(const std::vector<Point>& points);

/// Returns the z component of a × b.
inline double Cross(const Point& a, const Point& b)
{
  return a.x() * b.y() - a.y() * b.x();
}

/// Returns the angle from a to b in (−π, π], counter-clockwise positive.
inline double AngleBetween(const Point& a, const Point& b)
{
  return std::atan2(Cross(a, b), a.dot(b));
}

/// Returns the vector turned by 90° to the left.
inline Point TurnedLeft(const Point& vector)
{
  return { -vector.y(), vector.x() };
}

/// Returns the angle modulo 2π in (−π, π].
double WrapAngle(double angle);

/// Returns "(x, y)", for messages.
std::string Describe(const Point& point);
/// Returns "(x, y, z)", for messages.
std::string DescribeInSpace(const SpacePoint& point);
/// Returns "(x, y)" if z is 0, as in the plane, otherwise "(x, y, z)".
std::string DescribePlace(const SpacePoint& point);

/// Returns a number with at most that many significant digits, for messages.
std::string FormatNumber(double value, int digits = 6);

/// Returns the area enclosed by a loop, positive if it is counter-clockwise.
double SignedArea(const Loop& loop);

/// Returns the length of the diagonal of the loops' bounding box.
double BoundingDiagonal(const std::vector<Loop>& loops);
}
