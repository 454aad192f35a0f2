#include "AngularDomains.h"

#include "Error.h"

#include <algorithm>

namespace crossfield
{
namespace
{
constexpr double Degree = Pi / 180.0;

Point Direction(double angle)
{
  return { std::cos(angle), std::sin(angle) };
}

/// Returns a hexagon with two tips on the x axis, from which its sides rise at the angle `slope`.
Loop TippedHexagon(double width, double slope)
{
  const double tip = 0.5 * width;
  const double shoulder = 0.2 * width;
  const double height = (tip - shoulder) * std::tan(slope);
  return { { -tip, 0.0 }, { -shoulder, -height }, { shoulder, -height }, { tip, 0.0 },
    { shoulder, height }, { -shoulder, height } };
}
}

std::vector<Loop> HexagonalDomain(double radius)
{
  Loop loop;
  for (int i = 0; i < 6; ++i)
  {
    loop.push_back(radius * Direction(60.0 * i * Degree));
  }
  return { loop };
}

std::vector<Loop> StarDomain(double radius, double innerRadius)
{
  Loop loop;
  for (int i = 0; i < 10; ++i)
  {
    loop.push_back((i % 2 == 0 ? radius : innerRadius) * Direction((90.0 + 36.0 * i) * Degree));
  }
  return { loop };
}

std::vector<Loop> AngularBalancedDomain(double width)
{
  // The left side bends twice, by 35° each; the other corners turn by 72.5° each. Upper half:
  const Point flat(0.0, 0.15 * width);
  const Point left = flat + 0.35 * width * Direction(55.0 * Degree);
  const Point along = Direction(-17.5 * Degree);
  const Point right = left + (width - left.x()) / along.x() * along;
  const auto below = [](const Point& point) { return Point(point.x(), -point.y()); };
  return { { flat, below(flat), below(left), below(right), right, left } };
}

std::vector<Loop> AngularNegativeDomain(double width)
{
  return { TippedHexagon(width, 50.0 * Degree) };
}

std::vector<Loop> AngularPositiveDomain(double width)
{
  return { TippedHexagon(width, 40.0 * Degree) };
}

std::vector<Loop> AngularHoleDomain(double width, double edgeLength)
{
  const double radius = 0.1 * width;
  // A polygon with fewer sides would have corners; a multiple of 4 preserves the symmetry.
  const double segments = std::max(4.0, std::ceil(0.5 * Pi * radius / edgeLength));
  if (!(segments < 2.5e5))
  {
    throw Error("The edge length of a built-in domain would cut its curve into more than a million "
                "segments; give a larger one.");
  }
  const auto quarter = static_cast<int>(segments);
  Loop hole;
  for (int i = 0; i < 4 * quarter; ++i)
  {
    hole.push_back(radius * Direction(0.5 * Pi * i / quarter));
  }
  return { TippedHexagon(width, 40.0 * Degree), hole };
}
}
