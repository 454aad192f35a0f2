#pragma once

#include "QuadMesh.h"

#include <utility>

namespace crossfield
{
/// A grid of square cells that finds points of a quad mesh by position.
class PointGrid
{
public:
  explicit PointGrid(const QuadMesh& mesh);

  /// Returns the point nearest to a position within the search radius of point `p`, −1 if there is
  /// none. The radius is 0.4 of the shortest edge at `p`.
  int Find(const Point& place, int p) const;
  /// Returns the distance of a position from a point, in units of the shortest edge there.
  double EdgesBetween(const Point& place, int p) const;

private:
  using Entry = std::pair<long long, int>; ///< Row of the cell, and a point in it.

  std::array<long long, 2> CellOf(const Point& place) const;

  const QuadMesh& Mesh;
  std::vector<double> Reach; ///< Search radius per point.
  double Cell = 1.0;
  long long FirstColumn = 0;
  std::vector<int> Columns; ///< First of the entries of each column of cells, and their number.
  std::vector<Entry> Cells; ///< Points by column, then by row, sorted.
};
}
