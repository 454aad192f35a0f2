#pragma once

#include "QuadMesh.h"

#include <utility>

namespace crossfield
{
/// The points of a quad mesh in square cells, to find the one at a place.
class PointGrid
{
public:
  explicit PointGrid(const QuadMesh& mesh);

  /// The point within the reach of point `p` from a place; −1: none. Its reach is 0.4 of its shortest edge: nearer there is
  /// no other point.
  int Find(const Point& place, int p) const;
  /// Distance of a place from a point in shortest edges there.
  double EdgesBetween(const Point& place, int p) const;

private:
  using Entry = std::pair<std::array<long long, 2>, int>;

  std::array<long long, 2> CellOf(const Point& place) const;

  const QuadMesh& Mesh;
  std::vector<double> Reach;
  double Cell = 1.0;
  std::vector<Entry> Cells; ///< Ordered.
};
}
