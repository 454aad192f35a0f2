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
#include <array>
#include <cmath>
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
  int next = 0;  ///< The next side of the polygon.
  int twin = -1; ///< The side of the other polygon; −1 on the outer boundary.
  int line = -1; ///< The name of the line that it is on, an index in MaterialCells::lineNames.
  bool isAlongLine = false; ///< In its direction, not against it.
};

/// Sides around a region or the whole, each ending where the next one starts.
using SideLoop = std::vector<int>;

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
    this->MarkLines();
    this->NumberRegions();
    this->FindNodes();
    this->FollowInterfaces();
    this->NameInterfaces();
    this->FindCorners();
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
  void MarkLines()
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

  /// Returns the region on the left of a side, −1 for no side.
  int RegionAt(int side) const
  {
    return side < 0 ? -1 : this->RegionOf[Index(this->Sides[Index(side)].cell)];
  }
  /// Returns whether a side is on the boundary of its region.
  bool IsOnBoundary(int side) const
  {
    const CellSide& one = this->Sides[Index(side)];
    return one.line >= 0 || this->RegionAt(side) != this->RegionAt(one.twin);
  }
  bool IsInterface(int side) const
  {
    return this->Sides[Index(side)].twin >= 0 && this->IsOnBoundary(side);
  }
  bool IsSlit(int side) const
  {
    const CellSide& one = this->Sides[Index(side)];
    return one.line >= 0 && this->RegionAt(side) == this->RegionAt(one.twin);
  }

  /// Returns the loops of the sides for which `belongs` is true, which separate cells.
  template <class Belongs>
  std::vector<SideLoop> LoopsOf(const Belongs& belongs) const
  {
    std::vector<bool> done(this->Sides.size(), false);
    std::vector<SideLoop> loops;
    for (int start = 0; start < static_cast<int>(this->Sides.size()); ++start)
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

  /// Throws Error if loops visit a point several times that is not on a slit.
  void RequireSimple(const std::vector<SideLoop>& loops, const std::string& what) const
  {
    std::map<int, int> visits;
    std::map<int, bool> isOnSlit;
    for (const SideLoop& loop : loops)
    {
      for (const int side : loop)
      {
        const CellSide& one = this->Sides[Index(side)];
        ++visits[one.from];
        for (const int point : { one.from, one.to })
        {
          isOnSlit[point] = isOnSlit[point] || this->IsSlit(side);
        }
      }
    }
    for (const auto& [point, count] : visits)
    {
      if (count > 1 && !isOnSlit[point])
      {
        throw Error(what + " touches itself at " + Describe(this->At(point)) +
          "; separate the parts that meet there, or join them along an edge.");
      }
    }
  }

  Loop PointsOf(const SideLoop& loop) const
  {
    Loop points;
    std::transform(loop.begin(), loop.end(), std::back_inserter(points),
      [this](int side) { return this->At(this->Sides[Index(side)].from); });
    return points;
  }

  /// Returns the place of the point between two sides of a loop that is visited several times: it is moved into
  /// the angle between them, or along the one that is not on a slit.
  Point Separated(int incoming, int outgoing, double width) const
  {
    constexpr double Sharpest = 0.25; // sine from which points are moved farther than that
    const Point place = this->At(this->Sides[Index(outgoing)].from);
    const Point out = (this->At(this->Sides[Index(outgoing)].to) - place).normalized();
    const Point back = (this->At(this->Sides[Index(incoming)].from) - place).normalized();
    double angle = std::atan2(Cross(out, back), out.dot(back));
    angle += angle <= 0.0 ? 2.0 * Pi : 0.0;
    if (this->IsSlit(incoming) != this->IsSlit(outgoing))
    {
      const Point& along = this->IsSlit(incoming) ? out : back;
      return place + 0.5 * width / std::max(Sharpest, std::abs(std::sin(angle))) * along;
    }
    const Point middle = Eigen::Rotation2Dd(0.5 * angle) * out;
    return place + 0.5 * width / std::max(Sharpest, std::sin(0.5 * angle)) * middle;
  }

  /// Returns the polygons of the loops of a region, with slits open.
  std::vector<Loop> OpenPolygons(const std::vector<SideLoop>& loops) const
  {
    std::map<int, int> visits;
    std::map<int, double> shortest; // edge at a point
    Eigen::AlignedBox2d box;
    for (const SideLoop& loop : loops)
    {
      for (const int side : loop)
      {
        const CellSide& one = this->Sides[Index(side)];
        ++visits[one.from];
        box.extend(this->At(one.from));
        for (const int point : { one.from, one.to })
        {
          const double length = (this->At(one.to) - this->At(one.from)).norm();
          const auto found = shortest.emplace(point, length).first;
          found->second = std::min(found->second, length);
        }
      }
    }
    std::vector<Loop> polygons;
    for (const SideLoop& loop : loops)
    {
      polygons.push_back(this->PointsOf(loop));
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const int point = this->Sides[Index(loop[i])].from;
        if (visits[point] > 1)
        {
          constexpr double PartOfEdge = 0.1; // or the slit would change the directions of its edges
          const double width =
            std::min(SlitWidth * box.diagonal().norm(), PartOfEdge * shortest[point]);
          polygons.back()[i] =
            this->Separated(loop[(i + loop.size() - 1) % loop.size()], loop[i], width);
        }
      }
    }
    return polygons;
  }

  /// Finds the connected cells of each material, and their domains.
  void NumberRegions()
  {
    const std::size_t count = this->Cells.cells.size();
    UnionFind sets(count);
    for (const CellSide& side : this->Sides)
    {
      if (side.twin >= 0 && side.line < 0)
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
      const std::vector<SideLoop> loops = this->LoopsOf(
        [&](int side) { return this->RegionAt(side) == number && this->IsOnBoundary(side); });
      this->RequireSimple(loops, "The material '" + this->Cells.names[Index(material)] + "'");
      const std::vector<Loop> polygons = this->OpenPolygons(loops);
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
    for (int side = 0; side < static_cast<int>(this->Sides.size()); ++side)
    {
      const CellSide& one = this->Sides[Index(side)];
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
        found.push_back({ { this->At(point), isOnBoundary[Index(point)], {} }, point });
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
    return this->Sides[Index(two[0])].line != this->Sides[Index(two[1])].line;
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
    const int first = this->Sides[Index(start)].from;
    int point = this->Sides[Index(start)].to;
    while (this->NodeAt[Index(point)] < 0 && point != first)
    {
      for (const int side : this->LinesAt[Index(point)])
      {
        const int last = followed.sides.back();
        if (side != last && side != this->Sides[Index(last)].twin)
        {
          followed.sides.push_back(
            this->Sides[Index(side)].from == point ? side : this->Sides[Index(side)].twin);
          break;
        }
      }
      point = this->Sides[Index(followed.sides.back())].to;
    }
    // A closed line may have one corner.
    followed.piece.isClosed = point == first && this->LinesAt[Index(point)].size() == 2;
    this->Orient(followed.sides);
    followed.piece.regions = { this->RegionAt(followed.sides.front()),
      this->RegionAt(this->Sides[Index(followed.sides.front())].twin) };
    followed.piece.line = this->PointsOf(followed.sides);
    if (!followed.piece.isClosed)
    {
      followed.piece.line.push_back(this->At(this->Sides[Index(followed.sides.back())].to));
    }
    return followed;
  }

  /// Turns a piece so that the region with the lower number is on its left, or in the direction of its line.
  void Orient(SideLoop& sides) const
  {
    const int side = sides.front();
    const int left = this->RegionAt(side);
    const int right = this->RegionAt(this->Sides[Index(side)].twin);
    const auto along = std::count_if(
      sides.begin(), sides.end(), [this](int one) { return this->Sides[Index(one)].isAlongLine; });
    if (left > right || (left == right && 2 * along < static_cast<std::ptrdiff_t>(sides.size())))
    {
      std::reverse(sides.begin(), sides.end());
      std::transform(sides.begin(), sides.end(), sides.begin(),
        [this](int one) { return this->Sides[Index(one)].twin; });
    }
  }

  /// Collects the pieces of interfaces, and which of them the sides of regions are on.
  void FollowInterfaces()
  {
    std::vector<int> starts; // at nodes first, then from left to right, for closed lines
    for (int side = 0; side < static_cast<int>(this->Sides.size()); ++side)
    {
      if (this->IsInterface(side))
      {
        starts.push_back(side);
      }
    }
    const auto keyOf = [this](int side)
    {
      const CellSide& one = this->Sides[Index(side)];
      const Point& from = this->At(one.from);
      const Point& to = this->At(one.to);
      return std::array{ this->NodeAt[Index(one.from)] < 0 ? 1.0 : 0.0,
        this->RegionAt(side) > this->RegionAt(one.twin) ? 1.0 : 0.0, from.x(), from.y(), to.x(),
        to.y() };
    };
    std::sort(starts.begin(), starts.end(), [&](int a, int b) { return keyOf(a) < keyOf(b); });
    std::vector<bool> done(this->Sides.size(), false);
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
        done[Index(side)] = done[Index(this->Sides[Index(side)].twin)] = true;
      }
    }
    std::stable_sort(pieces.begin(), pieces.end(),
      [](const FollowedPiece& a, const FollowedPiece& b)
      {
        return a.piece.regions != b.piece.regions ? a.piece.regions < b.piece.regions
                                                  : IsBefore(a.piece.line[0], b.piece.line[0]);
      });
    std::vector<int> pieceOf(this->Sides.size(), -1); // as in Region::pieces
    for (FollowedPiece& one : pieces)
    {
      const auto number = static_cast<int>(this->Set.interfaces.size());
      for (const int side : one.sides)
      {
        pieceOf[Index(side)] = 2 * number;
        pieceOf[Index(this->Sides[Index(side)].twin)] = 2 * number + 1;
      }
      this->LineOf.push_back(this->Sides[Index(one.sides.front())].line);
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
          const int node = this->NodeAt[Index(this->Sides[Index(sides[i])].from)];
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
    std::map<std::string, int> counts;
    for (std::size_t p = 0; p < this->Set.interfaces.size(); ++p)
    {
      InterfacePiece& piece = this->Set.interfaces[p];
      const auto nameOf = [&](int region)
      { return this->Set.materials[Index(this->Set.regions[Index(region)].material)]; };
      const int line = this->LineOf[p];
      piece.name = piece.side = line >= 0
        ? this->Cells.lineNames[Index(line)]
        : nameOf(piece.regions[0]) + "+" + nameOf(piece.regions[1]);
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
    const std::vector<SideLoop> loops =
      this->LoopsOf([this](int side) { return this->Sides[Index(side)].twin < 0; });
    this->RequireSimple(loops, "The domain");
    std::vector<Loop> polygons;
    std::transform(loops.begin(), loops.end(), std::back_inserter(polygons),
      [this](const SideLoop& loop) { return this->PointsOf(loop); });
    this->Set.outlines = SplitParts(polygons);
  }

  const MaterialCells& Cells;
  std::vector<CellSide> Sides;
  std::vector<int> RegionOf;                         ///< Per cell.
  std::vector<std::vector<SideLoop>> SidesOfRegions; ///< Per region, of the loops of its domain.
  std::vector<int> NodeAt;                           ///< Per point, its node; −1 if it is none.
  std::vector<std::vector<int>> LinesAt;             ///< Per point, a side of each line there.
  std::vector<int> LineOf;                           ///< Per piece of an interface, CellSide::line.
};
}

RegionSet MakeRegionSet(const MaterialCells& cells)
{
  return std::move(RegionSetMaker(cells).Set);
}
}
