#include "HolePattern.h"

#include "LoopGap.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
std::optional<Circle> CircleOf(const Loop& loop)
{
  constexpr std::size_t FewestVertices = 12;
  constexpr double Tolerance = 0.01; // relative to the radius
  if (loop.size() < FewestVertices)
  {
    return std::nullopt;
  }
  Circle circle;
  double length = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    const Point& next = loop[(i + 1) % loop.size()];
    const double edge = (next - loop[i]).norm();
    circle.centre += 0.5 * edge * (loop[i] + next);
    length += edge;
  }
  circle.centre /= length;
  const auto distance = [&](const Point& point) { return (point - circle.centre).norm(); };
  const auto [nearest, farthest] = std::minmax_element(loop.begin(), loop.end(),
    [&](const Point& a, const Point& b) { return distance(a) < distance(b); });
  circle.radius = distance(*farthest);
  return distance(*nearest) > (1.0 - Tolerance) * circle.radius ? std::optional<Circle>(circle)
                                                                : std::nullopt;
}

std::vector<RoundHole> FindRoundHoles(const PlanarDomain& domain)
{
  std::vector<RoundHole> holes;
  for (std::size_t l = 1; l < domain.loops.size(); ++l)
  {
    if (const std::optional<Circle> circle = CircleOf(domain.loops[l]))
    {
      holes.push_back({ *circle, l, GapAround(domain, l) });
    }
  }
  return holes;
}

std::vector<Point> Centres(const std::vector<RoundHole>& holes)
{
  std::vector<Point> centres;
  std::transform(holes.begin(), holes.end(), std::back_inserter(centres),
    [](const RoundHole& hole) { return hole.centre; });
  return centres;
}

PlanarDomain FillHoles(const PlanarDomain& domain, const std::vector<RoundHole>& holes)
{
  PlanarDomain filled = domain;
  for (auto hole = holes.rbegin(); hole != holes.rend(); ++hole)
  {
    filled.loops.erase(filled.loops.begin() + static_cast<std::ptrdiff_t>(hole->loop));
  }
  return filled;
}

Configuration PatternAroundHoles(
  const std::vector<RoundHole>& holes, const std::vector<double>& crossAngles)
{
  // √2 radii are the corners of the square around a circle.
  constexpr double RelativeDistance = 1.41;
  constexpr double GapFraction = 0.4;
  Configuration pattern;
  for (std::size_t i = 0; i < holes.size(); ++i)
  {
    const RoundHole& hole = holes[i];
    const double distance =
      std::min(RelativeDistance * hole.radius, hole.radius + GapFraction * hole.gap);
    const double angle = crossAngles[i] + 0.25 * Pi;
    for (int quarter = 0; quarter < 4; ++quarter)
    {
      const double turned = angle + 0.5 * Pi * quarter;
      pattern.push_back({ hole.centre + distance * Point(std::cos(turned), std::sin(turned)), -1 });
    }
  }
  return pattern;
}
}
