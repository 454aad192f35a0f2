#include "DrawingRegions.h"

#include "Error.h"
#include "LineNetwork.h"
#include "PieceChains.h"
#include "PolygonTriangulation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <utility>

namespace crossfield
{
namespace
{
/// A bounded face of a network.
struct Face
{
  Loop polygon;
  std::string name; ///< Common name of the lines around it; empty if they have none.
};

/// The faces of a network.
class FaceTracer
{
public:
  FaceTracer(const std::vector<DrawnLine>& lines, ClosedCurves closedCurves)
    : Lines(lines)
    , Closed(closedCurves)
  {
    for (int half = 0; half < 2 * static_cast<int>(lines.size()); ++half)
    {
      this->Leaving[KeyOf(this->PointsOf(half).front())].push_back(half);
    }
    for (auto& [node, halves] : this->Leaving)
    {
      std::sort(halves.begin(), halves.end(),
        [this](int a, int b) { return this->AngleOf(a) < this->AngleOf(b); });
    }
  }

  bool HasOpenEnds() const
  {
    return std::any_of(this->Leaving.begin(), this->Leaving.end(),
      [](const auto& node) { return node.second.size() < 2; });
  }

  /// Returns each face as one polygon, with slits to its holes, the largest first.
  std::vector<Face> Trace()
  {
    std::vector<bool> done(2 * this->Lines.size(), false);
    std::vector<Face> outer;
    std::vector<Face> closed;   // curves that meet no other
    std::vector<Loop> outlines; // of connected sets of lines, clockwise
    for (int start = 0; start < static_cast<int>(done.size()); ++start)
    {
      if (done[static_cast<std::size_t>(start)])
      {
        continue;
      }
      Face face;
      int lines = 0;
      bool isRing = true; // of lines that meet no others
      bool haveOneName = true;
      for (int half = start; !done[static_cast<std::size_t>(half)]; half = this->NextOf(half))
      {
        done[static_cast<std::size_t>(half)] = true;
        const Loop points = this->PointsOf(half);
        face.polygon.insert(face.polygon.end(), points.begin(), points.end() - 1);
        const std::string& name = this->Lines[static_cast<std::size_t>(half / 2)].name;
        face.name = lines++ == 0 ? name : face.name;
        haveOneName = haveOneName && name == face.name;
        isRing = isRing && this->Leaving.at(KeyOf(points.front())).size() == 2;
      }
      face.name = haveOneName ? face.name : "";
      if (SignedArea(face.polygon) < 0.0)
      {
        outlines.push_back(std::move(face.polygon));
      }
      else
      {
        (isRing ? closed : outer).push_back(std::move(face));
      }
    }
    const std::size_t connected = outer.size();
    outer.insert(outer.end(), closed.begin(), closed.end());
    // A closed curve inside of a region is a hole, one inside of that is a region.
    for (std::size_t f = connected; f < outer.size() && this->Closed == ClosedCurves::Holes; ++f)
    {
      const auto around = std::count_if(outer.begin(), outer.end(),
        [&](const Face& other) { return Contains(other.polygon, outer[f].polygon); });
      outer[f].name = around % 2 == 1 ? Hole : outer[f].name;
    }
    const auto isLarger = [](const Face& a, const Face& b)
    { return SignedArea(a.polygon) > SignedArea(b.polygon); };
    std::sort(outer.begin(), outer.end(), isLarger);
    std::vector<std::vector<Loop>> holes(outer.size());
    for (const Loop& outline : outlines)
    {
      // The smallest face around it.
      for (std::size_t f = outer.size(); f-- > 0;)
      {
        if (Contains(outer[f].polygon, outline))
        {
          holes[f].push_back(outline);
          break;
        }
      }
    }
    for (std::size_t f = 0; f < outer.size(); ++f)
    {
      for (std::size_t h = 0; h < holes[f].size(); ++h)
      {
        JoinHole(holes[f], h, outer[f].polygon);
      }
    }
    outer.erase(std::remove_if(outer.begin(), outer.end(),
                  [](const Face& face) { return face.name.compare(0, Hole.size(), Hole) == 0; }),
      outer.end());
    std::sort(outer.begin(), outer.end(), isLarger); // without holes
    return outer;
  }

private:
  inline static const std::string Hole = "hole"; ///< How names of curves around holes begin.

  using Key = std::pair<double, double>;
  static Key KeyOf(const Point& place) { return { place.x(), place.y() }; }

  /// Returns the points of a line in one of its two directions.
  Loop PointsOf(int half) const
  {
    Loop points = this->Lines[static_cast<std::size_t>(half / 2)].points;
    if (half % 2 == 1)
    {
      std::reverse(points.begin(), points.end());
    }
    return points;
  }

  double AngleOf(int half) const
  {
    const Loop points = this->PointsOf(half);
    const Point direction = points[1] - points[0];
    return std::atan2(direction.y(), direction.x());
  }

  /// Returns the next direction around the face on the left: the first one clockwise from the way back.
  int NextOf(int half) const
  {
    const std::vector<int>& halves = this->Leaving.at(KeyOf(this->PointsOf(half).back()));
    const auto back = std::find(halves.begin(), halves.end(), half ^ 1);
    return back == halves.begin() ? halves.back() : *(back - 1);
  }

  /// Returns whether a polygon contains another one, of a set of lines that it does not meet.
  static bool Contains(const Loop& polygon, const Loop& other)
  {
    const Point& place = other[0];
    bool isInside = false;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      const Point& a = polygon[i];
      const Point& b = polygon[(i + 1) % polygon.size()];
      if (a == place)
      {
        return false; // its own outline
      }
      if ((a.y() > place.y()) != (b.y() > place.y()) &&
        place.x() < a.x() + (place.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x()))
      {
        isInside = !isInside;
      }
    }
    return isInside;
  }

  /// Returns whether a segment between two points of loops crosses a side of a loop.
  static bool Crosses(const Point& from, const Point& to, const Loop& loop)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point& a = loop[i];
      const Point& b = loop[(i + 1) % loop.size()];
      if (a == from || a == to || b == from || b == to)
      {
        continue;
      }
      const bool isDivided = Cross(to - from, a - from) * Cross(to - from, b - from) <= 0.0;
      if (isDivided && Cross(b - a, from - a) * Cross(b - a, to - a) <= 0.0)
      {
        return true;
      }
    }
    return false;
  }

  /// Joins one of the clockwise holes of a polygon to it by a slit, the shortest that crosses neither it nor
  /// any of the holes. There is one, as every polygon with holes has a triangulation.
  static void JoinHole(const std::vector<Loop>& holes, std::size_t number, Loop& polygon)
  {
    const Loop& hole = holes[number];
    std::vector<std::array<std::size_t, 2>> pairs;
    for (std::size_t i = 0; i < polygon.size(); ++i)
    {
      for (std::size_t j = 0; j < hole.size(); ++j)
      {
        pairs.push_back({ i, j });
      }
    }
    const auto lengthOf = [&](const std::array<std::size_t, 2>& pair)
    { return (polygon[pair[0]] - hole[pair[1]]).squaredNorm(); };
    std::sort(pairs.begin(), pairs.end(),
      [&](const auto& a, const auto& b)
      { return std::pair(lengthOf(a), a) < std::pair(lengthOf(b), b); });
    for (const auto& [i, j] : pairs)
    {
      const auto isCrossed = [&, from = polygon[i], to = hole[j]](const Loop& loop)
      { return Crosses(from, to, loop); };
      if (!isCrossed(polygon) && std::none_of(holes.begin(), holes.end(), isCrossed))
      {
        Loop slit;
        for (std::size_t k = 0; k <= hole.size(); ++k)
        {
          slit.push_back(hole[(j + k) % hole.size()]);
        }
        slit.push_back(polygon[i]);
        polygon.insert(
          polygon.begin() + static_cast<std::ptrdiff_t>(i) + 1, slit.begin(), slit.end());
        return;
      }
    }
    throw Error("The hole at " + Describe(hole[0]) +
      " is not separate from the curves around it; move it away from them.");
  }

  const std::vector<DrawnLine>& Lines;
  const ClosedCurves Closed;
  std::map<Key, std::vector<int>> Leaving; ///< Directions of lines by where they start, by angle.
};
}

bool TraceRegions(double tolerance, double turn, ClosedCurves closedCurves, Drawing& drawing)
{
  const std::vector<DrawnLine> lines = MakeLineNetwork(
    drawing, tolerance > 0.0 ? tolerance : DefaultJoinTolerance(drawing.pieces), turn);
  FaceTracer tracer(lines, closedCurves);
  if (tracer.HasOpenEnds())
  {
    return false;
  }
  const std::vector<Face> faces = tracer.Trace();
  if (faces.size() < 2)
  {
    return false;
  }
  const bool areNamed = closedCurves == ClosedCurves::Regions &&
    std::any_of(faces.begin(), faces.end(),
      [&faces](const Face& face) { return face.name != faces.front().name; });
  for (std::size_t f = 0; f < faces.size(); ++f)
  {
    const Loop& polygon = faces[f].polygon;
    const bool isNamed = areNamed && !faces[f].name.empty();
    const std::string material = isNamed ? faces[f].name : "region" + std::to_string(f + 1);
    for (const std::array<int, 3>& triangle : TriangulatePolygon(polygon))
    {
      DrawingFace face;
      face.material = material;
      for (const int corner : triangle)
      {
        face.points.push_back(polygon[static_cast<std::size_t>(corner)]);
      }
      drawing.faces.push_back(std::move(face));
    }
  }
  drawing.pieces.clear();
  for (const DrawnLine& line : lines)
  {
    for (std::size_t i = 1; i < line.points.size(); ++i)
    {
      drawing.pieces.push_back(LinePiece(line.points[i - 1], line.points[i]));
      drawing.pieces.back().name = line.name;
    }
  }
  return true;
}
}
