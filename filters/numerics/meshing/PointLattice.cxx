#include "PointLattice.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Returns the level l whose spacing 2⁻ˡ × largest is closest to a size, by ratio.
int LevelFor(double size, double largest)
{
  return std::max(0, static_cast<int>(std::lround(std::log2(largest / size))));
}

/// Returns by how many levels the coarsest lattice that contains the point (i, j) of a level is
/// coarser.
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

/// Returns the number of multiples of a step, from 0, that are below a length.
int CountBelow(double length, double step)
{
  return static_cast<int>(std::ceil(length / step));
}
}

double TriangularLattice::RowHeight() const
{
  return 0.5 * std::sqrt(3.0) * this->spacing;
}

Point TriangularLattice::At(int column, int row) const
{
  return this->origin + Point((column + 0.5 * (row % 2)) * this->spacing, row * this->RowHeight());
}

Point TriangularLattice::At(std::size_t number) const
{
  const auto inRow = static_cast<std::size_t>(this->columns);
  return this->At(static_cast<int>(number % inRow), static_cast<int>(number / inRow));
}

std::size_t TriangularLattice::Count() const
{
  return static_cast<std::size_t>(this->columns) * static_cast<std::size_t>(this->rows);
}

std::size_t TriangularLattice::NumberOf(int column, int row) const
{
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(this->columns) +
    static_cast<std::size_t>(column);
}

GradedLattice MakeGradedLattice(const SizeField& size)
{
  const double largest = size.GetMaximum();
  GradedLattice lattice;
  lattice.coarsest.origin = size.GetBox().min();
  lattice.coarsest.spacing = largest;
  lattice.coarsest.columns = CountBelow(size.GetBox().sizes().x(), largest);
  lattice.coarsest.rows = CountBelow(size.GetBox().sizes().y(), lattice.coarsest.RowHeight());
  const Point& origin = lattice.coarsest.origin;
  for (const SizeField::Leaf& leaf : size.Leaves())
  {
    const int level = LevelFor(leaf.LowerBound(), largest);
    if (level == 0)
    {
      continue;
    }
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
        if (own > 0 && LevelFor(leaf.SizeAt(point), largest) >= own)
        {
          lattice.finer.push_back(point);
        }
      }
    }
  }
  return lattice;
}
}
