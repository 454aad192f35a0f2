#include "LatticeCore.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
namespace
{
/// Marks the elements within `reach` of a marked one in a line of `count` elements, `stride` apart.
void Widen(std::vector<bool>& marks, std::size_t first, std::size_t stride, int count, int reach)
{
  const auto at = [&](int i) { return first + static_cast<std::size_t>(i) * stride; };
  int markedUpTo = 0; // all elements before it are final
  for (int i = 0; i < count; ++i)
  {
    if (!marks[at(i)])
    {
      continue;
    }
    // Marks to the left of i, then to its right up to the next marked element, so that new marks do
    // not spread.
    for (int j = std::max(markedUpTo, i - reach); j < i; ++j)
    {
      marks[at(j)] = true;
    }
    int end = i + 1;
    while (end < count && end <= i + reach && !marks[at(end)])
    {
      ++end;
    }
    for (int j = i + 1; j < end; ++j)
    {
      marks[at(j)] = true;
    }
    markedUpTo = end;
    i = end - 1;
  }
}

/// Marks the points of the lattice within `spacings` spacings of one of the other points, and some
/// beyond.
std::vector<bool> MarkNear(
  const TriangularLattice& lattice, const std::vector<Point>& others, int spacings)
{
  std::vector<bool> near(lattice.Count(), false);
  const auto nearest = [](double coordinate, int count)
  { return static_cast<int>(std::clamp(std::round(coordinate), 0.0, count - 1.0)); };
  for (const Point& other : others)
  {
    const Point place = other - lattice.origin;
    near[lattice.NumberOf(nearest(place.x() / lattice.spacing, lattice.columns),
      nearest(place.y() / lattice.RowHeight(), lattice.rows))] = true;
  }
  // One more for rounding to a lattice point and for the shift of odd rows.
  const auto rows = static_cast<int>(std::ceil(spacings * lattice.spacing / lattice.RowHeight()));
  for (int row = 0; row < lattice.rows; ++row)
  {
    Widen(near, lattice.NumberOf(0, row), 1, lattice.columns, spacings + 1);
  }
  for (int column = 0; column < lattice.columns; ++column)
  {
    Widen(near, lattice.NumberOf(column, 0), static_cast<std::size_t>(lattice.columns),
      lattice.rows, rows + 1);
  }
  return near;
}
}

LatticeCore::LatticeCore(const TriangularLattice& lattice, const std::vector<Point>& others,
  int margin, const std::function<bool(const Point&)>& isInside)
  : Lattice(lattice)
  , Core(lattice.Count(), false)
{
  const std::vector<bool> near = MarkNear(lattice, others, margin);
  for (int row = 0; row < lattice.rows; ++row)
  {
    bool inside = false;
    for (int column = 0; column < lattice.columns; ++column)
    {
      const std::size_t number = lattice.NumberOf(column, row);
      if (near[number])
      {
        continue;
      }
      if (column == 0 || near[number - 1])
      {
        // no boundary before the next point that is near one
        inside = isInside(lattice.At(column, row));
      }
      this->Core[number] = inside;
    }
  }
  this->CollectTriangles();
}

bool LatticeCore::IsCore(int column, int row) const
{
  return column >= 0 && row >= 0 && column < this->Lattice.columns && row < this->Lattice.rows &&
    this->Core[this->Lattice.NumberOf(column, row)];
}

bool LatticeCore::IsInterior(int column, int row) const
{
  const int right = TriangularLattice::ColumnBetween(column, row);
  return this->IsCore(column, row) && this->IsCore(column - 1, row) &&
    this->IsCore(column + 1, row) && this->IsCore(right - 1, row + 1) &&
    this->IsCore(right, row + 1) && this->IsCore(right - 1, row - 1) &&
    this->IsCore(right, row - 1);
}

void LatticeCore::CollectTriangles()
{
  // Triangles above and below each pair of neighbours in a row.
  for (int row = 0; row < this->Lattice.rows; ++row)
  {
    for (const int side : { 1, -1 })
    {
      bool beside = false; // whether the previous triangle of the row is in the core
      for (int column = 0; column + 1 < this->Lattice.columns; ++column)
      {
        const int between = TriangularLattice::ColumnBetween(column, row);
        if (!this->IsCore(column, row) || !this->IsCore(column + 1, row) ||
          !this->IsCore(between, row + side))
        {
          beside = false;
          continue;
        }
        const std::size_t left = this->Lattice.NumberOf(column, row);
        const std::size_t right = left + 1;
        const std::size_t apex = this->Lattice.NumberOf(between, row + side);
        if (!beside)
        {
          this->Firsts.push_back(this->Triangles.size());
        }
        beside = true;
        // Corners are counter-clockwise; `hasNeighbour` is whether the point across each edge is in
        // the core.
        const Triangle triangle =
          side > 0 ? Triangle{ left, right, apex } : Triangle{ right, left, apex };
        this->Triangles.push_back(triangle);
        const std::array<bool, 3> hasNeighbour = { this->IsCore(between, row - side),
          this->IsCore(between + side, row + side), this->IsCore(between - side, row + side) };
        for (std::size_t i = 0; i < 3; ++i)
        {
          if (!hasNeighbour[i])
          {
            this->Border.push_back({ triangle[i], triangle[(i + 1) % 3] });
          }
        }
      }
    }
  }
}
}
