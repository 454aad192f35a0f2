#include "Plane.h"

#include <Eigen/Geometry>

#include <sstream>

namespace crossfield
{
std::string Describe(const Point& point)
{
  return "(" + FormatNumber(point.x(), 9) + ", " + FormatNumber(point.y(), 9) + ")";
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
