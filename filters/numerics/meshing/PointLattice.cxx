#include "PointLattice.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Level l whose spacing 2⁻ˡ × largest comes closest to a size, in the sense of ratios.
int LevelFor(double size, double largest)
{
  return std::max(0, static_cast<int>(std::lround(std::log2(largest / size))));
}

/// By how many levels the coarsest lattice that has the point (i, j) of a level is coarser.
int CoarserLevels(long long i, long long j, int level)
{
  int coarser = 0;
  while (coarser < level && i % 2 == 0 && j % 2 == 0)
  {
    i /= 2;
    j /= 2;
    ++coarser;
  }
  return coarser;
}
}

std::vector<Point> GradedLattice(const SizeField& size)
{
  std::vector<Point> points;
  const double largest = size.GetMaximum();
  const std::vector<SizeField::Leaf> leaves = size.Leaves();
  const Point origin = leaves.front().box.min();
  for (const SizeField::Leaf& leaf : leaves)
  {
    const int level = LevelFor(leaf.LowerBound(), largest);
    const double spacing = std::ldexp(largest, -level);
    const double rowHeight = 0.5 * std::sqrt(3.0) * spacing;
    const Point lower = leaf.box.min() - origin;
    const Point upper = leaf.box.max() - origin;
    for (auto j = static_cast<long long>(std::ceil(lower.y() / rowHeight));
         static_cast<double>(j) * rowHeight < upper.y(); ++j)
    {
      const double shift = 0.5 * static_cast<double>(j) * spacing;
      for (auto i = static_cast<long long>(std::ceil((lower.x() - shift) / spacing));
           static_cast<double>(i) * spacing + shift < upper.x(); ++i)
      {
        const Point point = origin +
          Point(static_cast<double>(i) * spacing + shift, static_cast<double>(j) * rowHeight);
        const int own = level - CoarserLevels(i, j, level);
        if (own == 0 || LevelFor(leaf.SizeAt(point), largest) >= own)
        {
          points.push_back(point);
        }
      }
    }
  }
  return points;
}
}
