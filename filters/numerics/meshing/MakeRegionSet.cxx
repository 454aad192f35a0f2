#include "MakeRegionSet.h"

#include "BoundaryCorners.h"
#include "BoundaryLoops.h"
#include "CellSides.h"
#include "DomainParts.h"
#include "Index.h"
#include "MakePlanarDomain.h"
#include "OpenPolygons.h"
#include "UnionFind.h"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
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
    , Sides(cells)
  {
    this->Set.materials = cells.names;
    this->NumberRegions();
    this->FindNodes();
    this->FollowInterfaces();
    this->NameInterfaces();
    this->FindCorners();
    this->FindOutlines();
  }

  RegionSet Set;

private:
  /// Returns the region on the left of a side, −1 for no side.
  int RegionAt(int side) const
  {
    return side < 0 ? -1 : this->RegionOf[Index(this->Sides[side].cell)];
  }
  /// Returns whether a side is on the boundary of its region.
  bool IsOnBoundary(int side) const
  {
    const CellSide& one = this->Sides[side];
    return one.line >= 0 || this->RegionAt(side) != this->RegionAt(one.twin);
  }
  bool IsInterface(int side) const
  {
    return this->Sides[side].twin >= 0 && this->IsOnBoundary(side);
  }

  /// Finds the connected cells of each material, and their domains.
  void NumberRegions()
  {
    const std::size_t count = this->Cells.cells.size();
    UnionFind sets(count);
    for (const CellSide& side : this->Sides.All())
    {
      if (side.twin >= 0 && side.line < 0)
      {
        const int other = this->Sides[side.twin].cell;
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
    struct Found
    {
      Region region;
      int set = 0;
      std::vector<SideLoop> sides; ///< Of the loops of its domain.
    };
    std::vector<Found> found;
    for (const auto& [set, cells] : members)
    {
      const int material = this->Cells.materials[Index(cells.front())];
      const int number = set;
      const std::vector<SideLoop> loops = this->Sides.LoopsOf(
        [&](int side) { return this->RegionAt(side) == number && this->IsOnBoundary(side); });
      const std::vector<Loop> polygons = OpenPolygons(
        this->Sides, loops, "The material '" + this->Cells.names[Index(material)] + "'");
      std::map<std::array<double, 2>, int> startingAt;
      for (std::size_t l = 0; l < loops.size(); ++l)
      {
        for (std::size_t i = 0; i < loops[l].size(); ++i)
        {
          startingAt[{ polygons[l][i].x(), polygons[l][i].y() }] = loops[l][i];
        }
      }
      found.push_back({ { MakePlanarDomain(polygons), material, {} }, set, {} });
      for (const Loop& loop : found.back().region.domain.loops)
      {
        SideLoop& sides = found.back().sides.emplace_back();
        std::transform(loop.begin(), loop.end(), std::back_inserter(sides),
          [&startingAt](const Point& place) {
            return startingAt.at({ place.x(), place.y() });
          });
      }
    }
    std::sort(found.begin(), found.end(),
      [](const Found& a, const Found& b)
      {
        return a.region.material != b.region.material
          ? a.region.material < b.region.material
          : IsBefore(a.region.domain.loops[0][0], b.region.domain.loops[0][0]);
      });
    std::map<int, int> number;
    for (Found& one : found)
    {
      number[one.set] = static_cast<int>(this->Set.regions.size());
      this->Set.regions.push_back(std::move(one.region));
      this->SidesOfRegions.push_back(std::move(one.sides));
    }
    for (int& region : this->RegionOf)
    {
      region = number[region];
    }
  }

  /// Finds the points where pieces end.
  void FindNodes()
  {
    this->LinesAt.resize(this->Cells.points.size());
    std::vector<bool> isOnBoundary(this->Cells.points.size(), false);
    for (int side = 0; side < this->Sides.Count(); ++side)
    {
      const CellSide& one = this->Sides[side];
      if (this->IsOnBoundary(side) && one.twin < side) // once for each line
      {
        for (const int point : { one.from, one.to })
        {
          this->LinesAt[Index(point)].push_back(side);
          isOnBoundary[Index(point)] = isOnBoundary[Index(point)] || one.twin < 0;
        }
      }
    }
    std::vector<std::pair<RegionNode, int>> found;
    for (int point = 0; point < static_cast<int>(this->LinesAt.size()); ++point)
    {
      const std::vector<int>& lines = this->LinesAt[Index(point)];
      const bool meets = std::any_of(
        lines.begin(), lines.end(), [this](int side) { return this->IsInterface(side); });
      if (meets && (lines.size() != 2 || this->HasCorner(point, lines) || this->HasEnd(lines)))
      {
        found.push_back({ { this->Sides.At(point), isOnBoundary[Index(point)], {} }, point });
      }
    }
    std::sort(found.begin(), found.end(),
      [](const auto& a, const auto& b) { return IsBefore(a.first.place, b.first.place); });
    this->NodeAt.assign(this->Cells.points.size(), -1);
    for (auto& [node, point] : found)
    {
      this->NodeAt[Index(point)] = static_cast<int>(this->Set.nodes.size());
      this->Set.nodes.push_back(std::move(node));
    }
  }

  /// Returns whether a line ends, or another begins, between two sides.
  bool HasEnd(const std::vector<int>& two) const
  {
    return this->Sides[two[0]].line != this->Sides[two[1]].line;
  }

  /// Returns whether the two sides at a point make a corner.
  bool HasCorner(int point, const std::vector<int>& two) const
  {
    const auto away = [&](int side) -> Point
    {
      const CellSide& one = this->Sides[side];
      return this->Sides.At(one.from == point ? one.to : one.from) - this->Sides.At(point);
    };
    return IsCorner(AngleBetween(-away(two[0]), away(two[1])));
  }

  /// A piece with the sides on its left.
  struct FollowedPiece
  {
    InterfacePiece piece;
    SideLoop sides;
  };

  /// Returns the piece from a side up to the next node, or back to its start.
  FollowedPiece Follow(int start) const
  {
    FollowedPiece followed;
    followed.sides.push_back(start);
    const int first = this->Sides[start].from;
    int point = this->Sides[start].to;
    while (this->NodeAt[Index(point)] < 0 && point != first)
    {
      for (const int side : this->LinesAt[Index(point)])
      {
        const int last = followed.sides.back();
        if (side != last && side != this->Sides[last].twin)
        {
          followed.sides.push_back(this->Sides[side].from == point ? side : this->Sides[side].twin);
          break;
        }
      }
      point = this->Sides[followed.sides.back()].to;
    }
    // A closed line may have one corner.
    followed.piece.isClosed = point == first && this->LinesAt[Index(point)].size() == 2;
    this->Orient(followed.sides);
    followed.piece.regions = { this->RegionAt(followed.sides.front()),
      this->RegionAt(this->Sides[followed.sides.front()].twin) };
    followed.piece.line = this->Sides.PointsOf(followed.sides);
    if (!followed.piece.isClosed)
    {
      followed.piece.line.push_back(this->Sides.At(this->Sides[followed.sides.back()].to));
    }
    return followed;
  }

  /// Turns a piece so that the region with the lower number is on its left, or in the direction of its line.
  void Orient(SideLoop& sides) const
  {
    const int side = sides.front();
    const int left = this->RegionAt(side);
    const int right = this->RegionAt(this->Sides[side].twin);
    const auto along = std::count_if(
      sides.begin(), sides.end(), [this](int one) { return this->Sides[one].isAlongLine; });
    if (left > right || (left == right && 2 * along < static_cast<std::ptrdiff_t>(sides.size())))
    {
      std::reverse(sides.begin(), sides.end());
      std::transform(sides.begin(), sides.end(), sides.begin(),
        [this](int one) { return this->Sides[one].twin; });
    }
  }

  /// Collects the pieces of interfaces, and which of them the sides of regions are on.
  void FollowInterfaces()
  {
    std::vector<int> starts; // at nodes first, then from left to right, for closed lines
    for (int side = 0; side < this->Sides.Count(); ++side)
    {
      if (this->IsInterface(side))
      {
        starts.push_back(side);
      }
    }
    const auto keyOf = [this](int side)
    {
      const CellSide& one = this->Sides[side];
      const Point& from = this->Sides.At(one.from);
      const Point& to = this->Sides.At(one.to);
      return std::array{ this->NodeAt[Index(one.from)] < 0 ? 1.0 : 0.0,
        this->RegionAt(side) > this->RegionAt(one.twin) ? 1.0 : 0.0, from.x(), from.y(), to.x(),
        to.y() };
    };
    std::sort(starts.begin(), starts.end(), [&](int a, int b) { return keyOf(a) < keyOf(b); });
    std::vector<bool> done(Index(this->Sides.Count()), false);
    std::vector<FollowedPiece> pieces;
    for (const int start : starts)
    {
      if (done[Index(start)])
      {
        continue;
      }
      pieces.push_back(this->Follow(start));
      for (const int side : pieces.back().sides)
      {
        done[Index(side)] = done[Index(this->Sides[side].twin)] = true;
      }
    }
    std::stable_sort(pieces.begin(), pieces.end(),
      [](const FollowedPiece& a, const FollowedPiece& b)
      {
        return a.piece.regions != b.piece.regions ? a.piece.regions < b.piece.regions
                                                  : IsBefore(a.piece.line[0], b.piece.line[0]);
      });
    std::vector<int> pieceOf(Index(this->Sides.Count()), -1); // as in Region::pieces
    for (FollowedPiece& one : pieces)
    {
      const auto number = static_cast<int>(this->Set.interfaces.size());
      for (const int side : one.sides)
      {
        pieceOf[Index(side)] = 2 * number;
        pieceOf[Index(this->Sides[side].twin)] = 2 * number + 1;
      }
      this->LineOf.push_back(this->Sides[one.sides.front()].line);
      this->Set.interfaces.push_back(std::move(one.piece));
    }
    for (std::size_t r = 0; r < this->Set.regions.size(); ++r)
    {
      for (const SideLoop& sides : this->SidesOfRegions[r])
      {
        std::vector<int>& ofLoop = this->Set.regions[r].pieces.emplace_back();
        std::transform(sides.begin(), sides.end(), std::back_inserter(ofLoop),
          [&pieceOf](int side) { return pieceOf[Index(side)]; });
      }
    }
  }

  /// Finds the corners of regions at nodes.
  void FindCorners()
  {
    for (std::size_t r = 0; r < this->SidesOfRegions.size(); ++r)
    {
      for (std::size_t l = 0; l < this->SidesOfRegions[r].size(); ++l)
      {
        const SideLoop& sides = this->SidesOfRegions[r][l];
        for (std::size_t i = 0; i < sides.size(); ++i)
        {
          const int node = this->NodeAt[Index(this->Sides[sides[i]].from)];
          if (node >= 0)
          {
            this->Set.nodes[Index(node)].corners.push_back({ r, l, i });
          }
        }
      }
    }
  }

  void NameInterfaces()
  {
    for (std::size_t p = 0; p < this->Set.interfaces.size(); ++p)
    {
      InterfacePiece& piece = this->Set.interfaces[p];
      const auto nameOf = [&](int region)
      { return this->Set.materials[Index(this->Set.regions[Index(region)].material)]; };
      const int line = this->LineOf[p];
      piece.side = line >= 0 ? this->Cells.lineNames[Index(line)]
                             : nameOf(piece.regions[0]) + "+" + nameOf(piece.regions[1]);
    }
    NumberInterfaces(this->Set);
  }

  void FindOutlines()
  {
    const std::vector<SideLoop> loops =
      this->Sides.LoopsOf([this](int side) { return this->Sides[side].twin < 0; });
    this->Set.outlines = SplitParts(OpenPolygons(this->Sides, loops, "The domain"));
  }

  const MaterialCells& Cells;
  const CellSides Sides;
  std::vector<int> RegionOf;                         ///< Per cell.
  std::vector<std::vector<SideLoop>> SidesOfRegions; ///< Per region, of the loops of its domain.
  std::vector<int> NodeAt;                           ///< Per point, its node; −1 if it is none.
  std::vector<std::vector<int>> LinesAt;             ///< Per point, a side of each line there.
  std::vector<int> LineOf;                           ///< Per piece of an interface, CellSide::line.
};
}

void NumberInterfaces(RegionSet& set)
{
  std::map<std::string, int> counts;
  for (const InterfacePiece& piece : set.interfaces)
  {
    ++counts[piece.side];
  }
  std::map<std::string, int> numbers;
  for (InterfacePiece& piece : set.interfaces)
  {
    piece.name = piece.side;
    if (counts[piece.side] > 1)
    {
      piece.name += "." + std::to_string(++numbers[piece.side]);
    }
  }
}

RegionSet MakeRegionSet(const MaterialCells& cells)
{
  return std::move(RegionSetMaker(cells).Set);
}
}
