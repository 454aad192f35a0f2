#include "CellSides.h"

#include "Error.h"
#include "Segment.h"
#include "SegmentSearch.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace crossfield
{
CellSides::CellSides(const MaterialCells& cells)
  : Cells(cells)
{
  this->RequireNames();
  this->Collect();
  this->RequireSharedPoints();
  this->MarkLines();
}

Loop CellSides::PointsOf(const SideLoop& loop) const
{
  Loop points;
  std::transform(loop.begin(), loop.end(), std::back_inserter(points),
    [this](int side) { return this->At((*this)[side].from); });
  return points;
}

/// Throws Error if the material of a cell has no name.
void CellSides::RequireNames() const
{
  for (std::size_t cell = 0; cell < this->Cells.cells.size(); ++cell)
  {
    if (this->Cells.names[Index(this->Cells.materials[cell])].empty())
    {
      throw Error("The cell at " + Describe(this->At(this->Cells.cells[cell][0])) +
        " has a material with an empty name; give each cell the name of its material.");
    }
  }
}

/// Throws Error if cells touch without having the same points there.
void CellSides::RequireSharedPoints() const
{
  constexpr double Touching = 1e-6; // relative to the extent, as points that are in a plane
  std::vector<SegmentSearch::Segment> open;
  std::vector<const CellSide*> sides;
  Eigen::AlignedBox2d box;
  for (const CellSide& side : this->Sides)
  {
    if (side.twin < 0)
    {
      open.push_back({ this->At(side.from), this->At(side.to) });
      sides.push_back(&side);
      box.extend(this->At(side.from));
    }
  }
  std::map<int, int> before; // the point before each one on the boundary
  for (const CellSide* const side : sides)
  {
    before[side->to] = side->from;
  }
  const SegmentSearch search(open);
  const double reach = Touching * box.diagonal().norm();
  for (const CellSide* const side : sides)
  {
    const Point& place = this->At(side->from);
    search.ForNear(place, reach,
      [&](std::size_t other)
      {
        const CellSide& near = *sides[other];
        const bool isBesideTinyEdge =
          (side->to == near.from && (place - open[other][0]).norm() <= reach) ||
          (before[side->from] == near.to && (place - open[other][1]).norm() <= reach);
        if (near.from != side->from && near.to != side->from && !isBesideTinyEdge &&
          OffsetFromSegment(place, open[other][0], open[other][1]).norm() <= reach)
        {
          throw Error("The point at " + Describe(place) +
            " is on the edge of another cell, but is none of its points; give cells that touch the same "
            "points on the line between them.");
        }
      });
  }
}

void CellSides::Collect()
{
  for (int cell = 0; cell < static_cast<int>(this->Cells.cells.size()); ++cell)
  {
    std::vector<int> corners = this->Cells.cells[Index(cell)];
    Loop polygon;
    std::transform(corners.begin(), corners.end(), std::back_inserter(polygon),
      [this](int corner) { return this->At(corner); });
    if (SignedArea(polygon) < 0.0)
    {
      std::reverse(corners.begin(), corners.end());
    }
    const auto first = static_cast<int>(this->Sides.size());
    const auto count = static_cast<int>(corners.size());
    for (int i = 0; i < count; ++i)
    {
      const int next = (i + 1) % count;
      this->Sides.push_back({ corners[Index(i)], corners[Index(next)], cell, first + next });
    }
  }
  std::vector<int> order(this->Sides.size());
  std::iota(order.begin(), order.end(), 0);
  const auto edgeOf = [this](int side)
  {
    return std::pair<int, int>(
      std::minmax({ this->Sides[Index(side)].from, this->Sides[Index(side)].to }));
  };
  std::sort(order.begin(), order.end(),
    [&](int a, int b) { return std::pair(edgeOf(a), a) < std::pair(edgeOf(b), b); });
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    CellSide& one = this->Sides[Index(order[i - 1])];
    CellSide& two = this->Sides[Index(order[i])];
    if (edgeOf(order[i - 1]) != edgeOf(order[i]))
    {
      continue;
    }
    if (one.twin >= 0 || one.from == two.from)
    {
      throw Error("Cells of the domain overlap at the edge near " + Describe(this->At(one.from)) +
        "; give a planar mesh that covers each material once.");
    }
    one.twin = order[i];
    two.twin = order[i - 1];
  }
}

/// Marks the sides on lines; those on the outer boundary are none.
void CellSides::MarkLines()
{
  std::map<std::array<int, 2>, std::size_t>
    edges; // with their line, by its points in its direction
  for (std::size_t e = 0; e < this->Cells.lines.size(); ++e)
  {
    edges.emplace(this->Cells.lines[e].points, e);
  }
  for (CellSide& side : this->Sides)
  {
    const auto along = edges.find({ side.from, side.to });
    const auto against = edges.find({ side.to, side.from });
    const auto found = along == edges.end() ? against : along;
    if (side.twin >= 0 && found != edges.end())
    {
      side.line = this->Cells.lines[found->second].name;
      side.isAlongLine = found == along;
    }
  }
}
}
