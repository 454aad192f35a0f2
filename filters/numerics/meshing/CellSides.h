#pragma once

#include "Index.h"
#include "RegionSet.h"

#include <vector>

namespace crossfield
{
/// Side of a polygon, with the polygon on its left.
struct CellSide
{
  int from = 0;
  int to = 0;
  int cell = 0;
  int next = 0;  ///< The next side of the polygon.
  int twin = -1; ///< The side of the other polygon; −1 on the outer boundary.
  int line = -1; ///< The name of the line that it is on, an index in MaterialCells::lineNames.
  bool isAlongLine = false; ///< In its direction, not against it.
};

/// Sides around a region or the whole, each ending where the next one starts.
using SideLoop = std::vector<int>;

/// The sides of cells, oriented counter-clockwise, with what is on the other side of each.
class CellSides
{
public:
  /// Throws Error if a material has no name, an edge has more than two polygons or one of them on both sides,
  /// or cells touch without having the same points there. `cells` must live as long as this object.
  explicit CellSides(const MaterialCells& cells);

  int Count() const { return static_cast<int>(this->Sides.size()); }
  const CellSide& operator[](int side) const { return this->Sides[Index(side)]; }
  const std::vector<CellSide>& All() const { return this->Sides; }
  const Point& At(int point) const { return this->Cells.points[Index(point)]; }
  /// Returns the points where the sides of a loop start.
  Loop PointsOf(const SideLoop& loop) const;

  /// Returns the loops of the sides for which `belongs` is true, which separate cells.
  template <class Belongs>
  std::vector<SideLoop> LoopsOf(const Belongs& belongs) const
  {
    std::vector<bool> done(this->Sides.size(), false);
    std::vector<SideLoop> loops;
    for (int start = 0; start < this->Count(); ++start)
    {
      if (done[Index(start)] || !belongs(start))
      {
        continue;
      }
      loops.emplace_back();
      for (int side = start; !done[Index(side)];)
      {
        done[Index(side)] = true;
        loops.back().push_back(side);
        side = this->Sides[Index(side)].next;
        while (!belongs(side))
        {
          side = this->Sides[Index(this->Sides[Index(side)].twin)].next;
        }
      }
    }
    return loops;
  }

private:
  void RequireNames() const;
  void Collect();
  void RequireSharedPoints() const;
  void MarkLines();

  const MaterialCells& Cells;
  std::vector<CellSide> Sides;
};
}
