#include "HolePattern.h"

#include "LoopGap.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
std::vector<RoundHole> FindRoundHoles(const PlanarDomain& domain)
{
  constexpr std::size_t FewestVertices = 12;
  constexpr double Tolerance = 0.01; // relative to the radius
  std::vector<RoundHole> holes;
  for (std::size_t l = 1; l < domain.loops.size(); ++l)
  {
    const Loop& loop = domain.loops[l];
    RoundHole hole;
    hole.loop = l;
    double length = 0.0;
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point& next = loop[(i + 1) % loop.size()];
      const double edge = (next - loop[i]).norm();
      hole.centre += 0.5 * edge * (loop[i] + next);
      length += edge;
    }
    hole.centre /= length;
    const auto distance = [&](const Point& point) { return (point - hole.centre).norm(); };
    const auto [nearest, farthest] = std::minmax_element(loop.begin(), loop.end(),
      [&](const Point& a, const Point& b) { return distance(a) < distance(b); });
    hole.radius = distance(*farthest);
    if (loop.size() >= FewestVertices && distance(*nearest) > (1.0 - Tolerance) * hole.radius)
    {
      hole.gap = GapAround(domain, l);
      holes.push_back(hole);
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
