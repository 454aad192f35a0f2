#include "Plane.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace crossfield
{
std::vector<SpacePoint> InSpace(const std::vector<Point>& points)
{
  std::vector<SpacePoint> result;
  result.reserve(points.size());
  for (const Point& point : points)
  {
    result.push_back(InSpace(point));
  }
  return result;
}

std::string Describe(const Point& point)
{
  // Both coordinates have the decimals that give the larger one four significant digits: enough to
  // find the place, without the digits of rounding errors. Digits before the point are all given.
  const double largest = point.cwiseAbs().maxCoeff();
  const double step = largest > 0.0 && std::isfinite(largest)
    ? std::min(1.0, std::pow(10.0, std::floor(std::log10(largest)) - 3.0))
    : 1.0;
  const auto format = [step](double value)
  {
    constexpr int Digits = 9; // the rounded number has no more, unless it is above 1e9
    return FormatNumber(std::round(value / step) * step + 0.0, Digits); // + 0 removes the sign of 0
  };
  return "(" + format(point.x()) + ", " + format(point.y()) + ")";
}

std::string DescribeInSpace(const SpacePoint& point)
{
  return "(" + FormatNumber(point.x()) + ", " + FormatNumber(point.y()) + ", " +
    FormatNumber(point.z()) + ")";
}

std::string DescribePlace(const SpacePoint& point)
{
  return point.z() == 0.0 ? Describe(Point(point.head<2>())) : DescribeInSpace(point);
}

std::string FormatNumber(double value, int digits)
{
  std::ostringstream text;
  text.precision(digits);
  text << value;
  return text.str();
}

double SignedArea(const Loop& loop)
{
  double twice = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    // Relative to the first point, so that the area of a small loop far from the origin is
    // accurate.
    twice += Cross(loop[i] - loop[0], loop[(i + 1) % loop.size()] - loop[0]);
  }
  return 0.5 * twice;
}

double BoundingDiagonal(const std::vector<Loop>& loops)
{
  Eigen::AlignedBox2d box;
  for (const Loop& loop : loops)
  {
    for (const Point& point : loop)
    {
      box.extend(point);
    }
  }
  return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

double WrapAngle(double angle)
{
  const double wrapped = std::remainder(angle, 2.0 * Pi);
  return wrapped == -Pi ? Pi : wrapped;
}
}
