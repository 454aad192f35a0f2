#include "RandomConfigurations.h"

#include "DomainQueries.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Places singularities one after the other, each at the first random point that is far enough from
/// those before it and from the boundary. Returns whether all were placed.
bool PlaceAll(Random& random, const std::vector<int>& quarters, RandomCase& result)
{
  constexpr int MaximumTrials = 20000;
  const double distance =
    1.5 * std::sqrt(result.domain.Area() / static_cast<double>(QuadsOfRandomCases));
  Point lower = result.domain.loops[0][0];
  Point upper = lower;
  for (const Point& point : result.domain.loops[0])
  {
    lower = lower.cwiseMin(point);
    upper = upper.cwiseMax(point);
  }
  int trials = 0;
  for (const int quarter : quarters)
  {
    for (;; ++trials)
    {
      if (trials == MaximumTrials)
      {
        return false;
      }
      const Point place(random.Uniform(lower.x(), upper.x()), random.Uniform(lower.y(), upper.y()));
      if (SignedDistance(place, result.domain) >= distance &&
        std::all_of(result.singularities.begin(), result.singularities.end(),
          [&](const Singularity& other) { return (other.position - place).norm() >= distance; }))
      {
        result.singularities.push_back({ place, quarter });
        break;
      }
    }
  }
  return true;
}

void AddPairs(int pairs, std::vector<int>& quarters)
{
  for (; pairs > 0; --pairs)
  {
    quarters.push_back(1);
    quarters.push_back(-1);
  }
}

Loop Clockwise(Loop loop)
{
  std::reverse(loop.begin(), loop.end());
  return loop;
}
}

RandomCase RandomRing(std::uint32_t seed)
{
  Random random(seed);
  for (;;)
  {
    RandomCase result;
    const double inner = random.Uniform(0.15, 0.5);
    const double away = random.Uniform(0.0, 0.6 * (1.0 - inner));
    result.domain.loops = { RegularPolygon(96),
      Clockwise(RegularPolygon(96, inner, Point(away, 0.0))) };
    std::vector<int> quarters;
    AddPairs(random.Integer(2, 4), quarters);
    if (PlaceAll(random, quarters, result))
    {
      return result;
    }
  }
}

RandomCase RandomPlate(std::uint32_t seed)
{
  Random random(seed);
  for (;;)
  {
    RandomCase result;
    const double width = random.Uniform(1.0, 2.0);
    result.domain.loops = { { Point(0.0, 0.0), Point(width, 0.0), Point(width, 1.0),
      Point(0.0, 1.0) } };
    const int holes = random.Integer(2, 10);
    int trials = 0;
    while (static_cast<int>(result.domain.loops.size()) <= holes && ++trials < 10000)
    {
      const double radius = random.Uniform(0.03, 0.4 / std::sqrt(holes) * std::sqrt(width) * 0.6);
      const Point centre(random.Uniform(0.0, width), random.Uniform(0.0, 1.0));
      if (SignedDistance(centre, result.domain) >= 1.6 * radius + 0.02)
      {
        result.domain.loops.push_back(Clockwise(RegularPolygon(64, radius, centre)));
      }
    }
    std::vector<int> quarters(static_cast<std::size_t>(4 * holes), -1);
    AddPairs(random.Integer(0, 4), quarters);
    if (static_cast<int>(result.domain.loops.size()) == holes + 1 &&
      PlaceAll(random, quarters, result))
    {
      return result;
    }
  }
}
}
