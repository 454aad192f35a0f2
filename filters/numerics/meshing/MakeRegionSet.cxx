#include "MakeRegionSet.h"

#include "BoundaryCorners.h"
#include "BoundaryLoops.h"
#include "DomainParts.h"
#include "Error.h"
#include "Index.h"
#include "MakePlanarDomain.h"
#include "Segment.h"
#include "SegmentSearch.h"
#include "UnionFind.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <map>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Side of a polygon, with the polygon on its left.
struct CellSide
{
  int from = 0;
  int to = 0;
  int cell = 0;
  int twin = -1; ///< The side of the other polygon; −1 on the outer boundary.
};

bool IsBefore(const Point& a, const Point& b)
{
  return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
}

/// Collects regions and interfaces.
class RegionSetMaker
{
public:
  explicit RegionSetMaker(const MaterialCells& cells)
    : Cells(cells)
  {
    this->Set.materials = cells.names;
    this->RequireNames();
    this->CollectSides();
    this->RequireSharedPoints();
    this->NumberRegions();
    this->FindNodes();
    this->FollowInterfaces();
    this->NameInterfaces();
    this->FindOutlines();
  }

  RegionSet Set;

private:
  const Point& At(int point) const { return this->Cells.points[Index(point)]; }

  /// Throws Error if the material of a cell has no name.
  void RequireNames() const
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
  void RequireSharedPoints() const
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

  void CollectSides()
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
      for (std::size_t i = 0; i < corners.size(); ++i)
      {
        this->Sides.push_back({ corners[i], corners[(i + 1) % corners.size()], cell });
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

  /// Returns the region on the left of a side, −1 for no side.
  int RegionAt(int side) const
  {
    return side < 0 ? -1 : this->RegionOf[Index(this->Sides[Index(side)].cell)];
  }
  bool IsOnLine(int side) const
  {
    return this->RegionAt(side) != this->RegionAt(this->Sides[Index(side)].twin);
  }
  bool IsInterface(int side) const
  {
    return this->Sides[Index(side)].twin >= 0 && this->IsOnLine(side);
  }

  /// Returns the loops of the sides for which `belongs` is true. Throws Error if two of them start at
  /// one point.
  template <class Belongs>
  std::vector<Loop> LoopsOf(const Belongs& belongs, const std::string& what) const
  {
    std::map<int, int> startingAt;
    for (int side = 0; side < static_cast<int>(this->Sides.size()); ++side)
    {
      const int from = this->Sides[Index(side)].from;
      if (belongs(side) && !startingAt.emplace(from, side).second)
      {
        throw Error(what + " touches itself at " + Describe(this->At(from)) +
          "; separate the parts that meet there, or join them along an edge.");
      }
    }
    std::vector<Loop> loops;
    while (!startingAt.empty())
    {
      loops.emplace_back();
      for (auto next = startingAt.begin(); next != startingAt.end();)
      {
        const CellSide& side = this->Sides[Index(next->second)];
        loops.back().push_back(this->At(side.from));
        startingAt.erase(next);
        next = startingAt.find(side.to);
      }
    }
    return loops;
  }

  /// Finds the connected cells of each material, and their domains.
  void NumberRegions()
  {
    const std::size_t count = this->Cells.cells.size();
    UnionFind sets(count);
    for (const CellSide& side : this->Sides)
    {
      if (side.twin >= 0)
      {
        const int other = this->Sides[Index(side.twin)].cell;
        if (this->Cells.materials[Index(side.cell)] == this->Cells.materials[Index(other)])
        {
          sets.Join(side.cell, other);
        }
      }
    }
    this->RegionOf.assign(count, 0);
    std::map<int, std::vector<int>> members;
    for (int cell = 0; cell < static_cast<int>(count); ++cell)
    {
      const int set = sets.Find(cell);
      this->RegionOf[Index(cell)] = set;
      members[set].push_back(cell);
    }
    std::vector<std::pair<Region, int>> found;
    for (const auto& [set, cells] : members)
    {
      const int material = this->Cells.materials[Index(cells.front())];
      const std::string& name = this->Cells.names[Index(material)];
      const int region = set;
      found.push_back({ { MakePlanarDomain(this->LoopsOf([&](int side)
                            { return this->RegionAt(side) == region && this->IsOnLine(side); },
                            "The material '" + name + "'")),
                          material },
        region });
    }
    std::sort(found.begin(), found.end(),
      [](const std::pair<Region, int>& a, const std::pair<Region, int>& b)
      {
        return a.first.material != b.first.material
          ? a.first.material < b.first.material
          : IsBefore(a.first.domain.loops[0][0], b.first.domain.loops[0][0]);
      });
    std::map<int, int> number;
    for (auto& [region, set] : found)
    {
      number[set] = static_cast<int>(this->Set.regions.size());
      this->Set.regions.push_back(std::move(region));
    }
    for (int& region : this->RegionOf)
    {
      region = number[region];
    }
  }

  /// Finds the points where pieces end.
  void FindNodes()
  {
    std::vector<std::vector<int>> lines(this->Cells.points.size()); // sides of each line at a point
    std::vector<bool> isOnBoundary(this->Cells.points.size(), false);
    for (int side = 0; side < static_cast<int>(this->Sides.size()); ++side)
    {
      const CellSide& one = this->Sides[Index(side)];
      if (this->IsOnLine(side) && one.twin < side) // once for each line
      {
        lines[Index(one.from)].push_back(side);
        lines[Index(one.to)].push_back(side);
        isOnBoundary[Index(one.from)] = isOnBoundary[Index(one.from)] || one.twin < 0;
        isOnBoundary[Index(one.to)] = isOnBoundary[Index(one.to)] || one.twin < 0;
      }
    }
    this->IsNode.assign(this->Cells.points.size(), false);
    for (std::size_t point = 0; point < lines.size(); ++point)
    {
      this->LinesAt.push_back(lines[point].size());
      const bool meets = std::any_of(lines[point].begin(), lines[point].end(),
        [this](int side) { return this->IsInterface(side); });
      if (meets &&
        (lines[point].size() != 2 || this->HasCorner(static_cast<int>(point), lines[point])))
      {
        this->IsNode[point] = true;
        this->Set.nodes.push_back({ this->Cells.points[point], isOnBoundary[point] });
      }
    }
    std::sort(this->Set.nodes.begin(), this->Set.nodes.end(),
      [](const RegionNode& a, const RegionNode& b) { return IsBefore(a.place, b.place); });
  }

  /// Returns whether the two sides at a point make a corner.
  bool HasCorner(int point, const std::vector<int>& two) const
  {
    const auto away = [&](int side) -> Point
    {
      const CellSide& one = this->Sides[Index(side)];
      return this->At(one.from == point ? one.to : one.from) - this->At(point);
    };
    return IsCorner(AngleBetween(-away(two[0]), away(two[1])));
  }

  /// Removes the sides from a point up to the next node, or back to it, and returns their piece.
  InterfacePiece Follow(
    const std::array<int, 2>& regions, int point, std::map<int, int>& sides) const
  {
    InterfacePiece piece;
    piece.regions = regions;
    do
    {
      const auto side = sides.find(point);
      piece.line.push_back(this->At(point));
      point = this->Sides[Index(side->second)].to;
      sides.erase(side);
    } while (!this->IsNode[Index(point)] && sides.count(point) > 0);
    // A closed line may have one corner.
    piece.isClosed = this->At(point) == piece.line.front() &&
      (!this->IsNode[Index(point)] || this->LinesAt[Index(point)] == 2);
    if (!piece.isClosed)
    {
      piece.line.push_back(this->At(point));
    }
    return piece;
  }

  /// Collects the pieces of interfaces, each along the region with the lower number.
  void FollowInterfaces()
  {
    std::map<std::array<int, 2>, std::map<int, int>> startingAt; // per pair of regions
    for (int side = 0; side < static_cast<int>(this->Sides.size()); ++side)
    {
      const std::array<int, 2> regions = { this->RegionAt(side),
        this->RegionAt(this->Sides[Index(side)].twin) };
      if (this->IsInterface(side) && regions[0] < regions[1])
      {
        startingAt[regions][this->Sides[Index(side)].from] = side;
      }
    }
    for (auto& [regions, sides] : startingAt)
    {
      while (!sides.empty())
      {
        auto first = std::find_if(sides.begin(), sides.end(),
          [this](const std::pair<const int, int>& one) { return this->IsNode[Index(one.first)]; });
        if (first == sides.end()) // only closed lines are left
        {
          first = std::min_element(sides.begin(), sides.end(),
            [this](const std::pair<const int, int>& a, const std::pair<const int, int>& b)
            { return IsBefore(this->At(a.first), this->At(b.first)); });
        }
        this->Set.interfaces.push_back(this->Follow(regions, first->first, sides));
      }
    }
    std::stable_sort(this->Set.interfaces.begin(), this->Set.interfaces.end(),
      [](const InterfacePiece& a, const InterfacePiece& b)
      { return a.regions != b.regions ? a.regions < b.regions : IsBefore(a.line[0], b.line[0]); });
  }

  void NameInterfaces()
  {
    std::map<std::string, int> counts;
    for (InterfacePiece& piece : this->Set.interfaces)
    {
      const auto nameOf = [&](int region)
      { return this->Set.materials[Index(this->Set.regions[Index(region)].material)]; };
      piece.name = piece.side = nameOf(piece.regions[0]) + "+" + nameOf(piece.regions[1]);
      ++counts[piece.name];
    }
    std::map<std::string, int> numbers;
    for (InterfacePiece& piece : this->Set.interfaces)
    {
      if (counts[piece.name] > 1)
      {
        const int number = ++numbers[piece.name];
        piece.name += "." + std::to_string(number);
      }
    }
  }

  void FindOutlines()
  {
    this->Set.outlines = SplitParts(
      this->LoopsOf([this](int side) { return this->Sides[Index(side)].twin < 0; }, "The domain"));
  }

  const MaterialCells& Cells;
  std::vector<CellSide> Sides;
  std::vector<int> RegionOf;        ///< Per cell.
  std::vector<bool> IsNode;         ///< Per point.
  std::vector<std::size_t> LinesAt; ///< Number of lines at each point.
};
}

RegionSet MakeRegionSet(const MaterialCells& cells)
{
  return std::move(RegionSetMaker(cells).Set);
}
}
