#include "OpenPolygons.h"

#include "Error.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace crossfield
{
namespace
{
/// What loops have at a point.
struct Visited
{
  int times = 0;
  bool isOnSlit = false;
  double shortest = std::numeric_limits<double>::infinity(); ///< Length of a side.
};

/// Moves apart the points that loops visit several times.
class SlitOpener
{
public:
  SlitOpener(const CellSides& sides, const std::vector<SideLoop>& loops)
    : Sides(sides)
    , Loops(loops)
  {
    for (const SideLoop& loop : loops)
    {
      this->InLoops.insert(loop.begin(), loop.end());
    }
    Eigen::AlignedBox2d box;
    for (const int side : this->InLoops)
    {
      const CellSide& one = sides[side];
      ++this->At[one.from].times;
      box.extend(sides.At(one.from));
      for (const int point : { one.from, one.to })
      {
        Visited& visited = this->At[point];
        visited.isOnSlit = visited.isOnSlit || this->IsSlit(side);
        visited.shortest =
          std::min(visited.shortest, (sides.At(one.to) - sides.At(one.from)).norm());
      }
    }
    this->Width = SlitWidth * box.diagonal().norm();
  }

  void RequireSlits(const std::string& what) const
  {
    for (const auto& [point, visited] : this->At)
    {
      if (visited.times > 1 && !visited.isOnSlit)
      {
        throw Error(what + " touches itself at " + Describe(this->Sides.At(point)) +
          "; separate the parts that meet there, or join them along an edge.");
      }
    }
  }

  std::vector<Loop> Polygons() const
  {
    std::vector<Loop> polygons;
    for (const SideLoop& loop : this->Loops)
    {
      polygons.push_back(this->Sides.PointsOf(loop));
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        if (this->At.at(this->Sides[loop[i]].from).times > 1)
        {
          polygons.back()[i] = this->Separated(loop[(i + loop.size() - 1) % loop.size()], loop[i]);
        }
      }
    }
    return polygons;
  }

private:
  bool IsSlit(int side) const { return this->InLoops.count(this->Sides[side].twin) > 0; }

  /// Returns the place of the point between two sides of a loop: it is moved into the angle between them, or
  /// along the one that is not on a slit.
  Point Separated(int incoming, int outgoing) const
  {
    constexpr double PartOfEdge = 0.1;    // or the directions of sides would change much
    constexpr double SmallestSine = 0.25; // or points would be moved far into sharp angles
    const int point = this->Sides[outgoing].from;
    const double half = 0.5 * std::min(this->Width, PartOfEdge * this->At.at(point).shortest);
    const Point& place = this->Sides.At(point);
    const Point out = (this->Sides.At(this->Sides[outgoing].to) - place).normalized();
    const Point back = (this->Sides.At(this->Sides[incoming].from) - place).normalized();
    double angle = std::atan2(Cross(out, back), out.dot(back));
    angle += angle <= 0.0 ? 2.0 * Pi : 0.0;
    if (this->IsSlit(incoming) != this->IsSlit(outgoing))
    {
      const Point& along = this->IsSlit(incoming) ? out : back;
      return place + half / std::max(SmallestSine, std::abs(std::sin(angle))) * along;
    }
    const Point middle = Eigen::Rotation2Dd(0.5 * angle) * out;
    return place + half / std::max(SmallestSine, std::sin(0.5 * angle)) * middle;
  }

  const CellSides& Sides;
  const std::vector<SideLoop>& Loops;
  std::set<int> InLoops;
  std::map<int, Visited> At; ///< By point.
  double Width = 0.0;
};
}

std::vector<Loop> OpenPolygons(
  const CellSides& sides, const std::vector<SideLoop>& loops, const std::string& what)
{
  const SlitOpener opener(sides, loops);
  opener.RequireSlits(what);
  return opener.Polygons();
}
}
