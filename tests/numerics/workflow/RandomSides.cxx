#include "RandomSides.h"

#include "MakePlanarDomain.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Divides the segments of a polygon, so that names may change on them.
Loop Divided(const Loop& corners, double length)
{
  Loop loop;
  for (std::size_t i = 0; i < corners.size(); ++i)
  {
    const Point& from = corners[i];
    const Point& to = corners[(i + 1) % corners.size()];
    const int count = std::max(1, static_cast<int>(std::ceil((to - from).norm() / length)));
    for (int j = 0; j < count; ++j)
    {
      loop.push_back(from + static_cast<double>(j) / count * (to - from));
    }
  }
  return loop;
}

Loop Rectangle(const Point& centre, double width, double height)
{
  const Point a(0.5 * width, 0.5 * height);
  const Point b(0.5 * width, -0.5 * height);
  return { centre - a, centre + b, centre + a, centre - b };
}
}

PlanarDomain RandomPart(Random& random)
{
  const int kind = random.Integer(0, 2);
  std::vector<Loop> loops;
  if (kind == 0)
  {
    loops = RandomSmoothDomain(random, 96).loops;
  }
  else if (kind == 1)
  {
    loops.push_back(
      Divided(Rectangle(Point::Zero(), 2.0, random.Uniform(1.2, 2.0)), random.Uniform(0.05, 0.3)));
  }
  else
  {
    const double notch = random.Uniform(0.3, 0.7);
    loops.push_back(Divided(
      { { -1, -0.8 }, { 1, -0.8 }, { 1, notch - 0.3 }, { 0.4, notch }, { 0.4, 0.9 }, { -1, 0.9 } },
      random.Uniform(0.05, 0.3)));
  }
  const int holes = random.Integer(0, 2);
  const std::vector<Point> centres = { { -0.35, -0.2 }, { 0.35, -0.25 } };
  for (int i = 0; i < holes; ++i)
  {
    const double radius = random.Uniform(0.08, 0.17);
    loops.push_back(random.Integer(0, 2) > 0
        ? RegularPolygon(random.Integer(24, 60), radius, centres[static_cast<std::size_t>(i)])
        : Divided(Rectangle(centres[static_cast<std::size_t>(i)], 1.5 * radius, radius), 0.04));
  }
  Similarity place;
  place.angle = random.Uniform(0.0, 6.0);
  place.scale = std::pow(10.0, random.Uniform(-2.0, 2.0));
  return MakePlanarDomain(place(loops));
}

SegmentNames RandomNames(Random& random, const PlanarDomain& domain, int pieces)
{
  SegmentNames names;
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    const auto count = static_cast<int>(domain.loops[l].size());
    std::vector<int> ends;
    const int changes = random.Integer(0, pieces);
    // changes at least an eighth of the average piece apart
    const int apart = std::max(1, count / (8 * std::max(1, pieces)));
    for (int i = 0; i < changes; ++i)
    {
      const int end = random.Integer(0, count - 1);
      if (std::none_of(ends.begin(), ends.end(),
            [&](int other)
            {
              const int distance = std::abs(other - end);
              return std::min(distance, count - distance) < apart;
            }))
      {
        ends.push_back(end);
      }
    }
    std::sort(ends.begin(), ends.end());
    std::vector<std::string> ofLoop(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
    {
      const auto piece = std::upper_bound(ends.begin(), ends.end(), i) - ends.begin();
      const auto cyclic = ends.empty() ? 0 : piece % static_cast<std::ptrdiff_t>(ends.size());
      // the last of five or more pieces has the name of the second one
      const auto number = cyclic == 4 ? 1 : cyclic;
      ofLoop[static_cast<std::size_t>(i)] =
        "loop" + std::to_string(l) + "piece" + std::to_string(number);
    }
    names.push_back(std::move(ofLoop));
  }
  return names;
}
}
