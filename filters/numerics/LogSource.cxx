#include "LogSource.h"

namespace crossfield
{
double LogIntegral(const std::vector<std::array<Point, 2>>& boundary, const Point& centre)
{
  double integral = 0.0;
  for (const auto& [from, to] : boundary)
  {
    const double length = (to - from).norm();
    const Point tangent = (to - from) / length;
    const Point start = from - centre;
    const Point end = to - centre;
    // The outward normal is the tangent turned by −90°: (x − centre) · ν is the same on all the edge.
    const double height = Cross(start, tangent);
    const auto sLogR = [&tangent](const Point& x)
    { return x.isZero(0.0) ? 0.0 : x.dot(tangent) * std::log(x.norm()); };
    const double angle = start.isZero(0.0) || end.isZero(0.0) ? 0.0 : AngleBetween(start, end);
    const double logAlong = sLogR(end) - sLogR(start) - length + height * angle;
    integral += 0.5 * height * (logAlong - 0.5 * length);
  }
  return integral;
}
}
