#include "CellsAlongLines.h"

#include "CellSides.h"
#include "Error.h"
#include "Index.h"
#include "MesherTriangulation.h"
#include "Segment.h"
#include "SegmentSearch.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <set>
#include <utility>

namespace crossfield
{
namespace
{
/// Largest distance of a sampled curve from the curve, relative to the extent, and a margin: a line that ends on
/// the curve may end so far from its polygon.
constexpr double SampledDistance = 2e-4;

/// Distance relative to the extent up to which an edge of the triangulation is on a segment: rounding.
constexpr double OnSegment = 1e-9;

using Crossing = CGAL::Constrained_Delaunay_triangulation_2<mesher::Kernel, CGAL::Default,
  CGAL::Exact_predicates_tag>;
using Key = std::array<double, 2>;

Key KeyOf(const Point& place)
{
  return { place.x(), place.y() };
}

/// Triangulates materials and lines.
class LineTriangulation
{
public:
  LineTriangulation(const std::vector<MaterialEdge>& edges, const std::vector<SegmentOnLine>& lines)
    : Edges(edges)
    , Lines(lines)
  {
    Eigen::AlignedBox2d box;
    for (const MaterialEdge& edge : edges)
    {
      box.extend(edge.from);
      box.extend(edge.to);
    }
    this->Extent = box.diagonal().norm();
    this->Attach();
    this->DivideNearEnds();
    for (const MaterialEdge& edge : this->Edges)
    {
      this->Insert(edge.from, edge.to);
    }
    for (const SegmentOnLine& line : this->Lines)
    {
      this->Insert(line.from, line.to);
    }
  }

  MaterialCells Collect()
  {
    MaterialCells cells;
    std::map<Crossing::Vertex_handle, int> numbers;
    const auto numberOf = [&](const Crossing::Vertex_handle& vertex)
    {
      const auto [found, isNew] = numbers.emplace(vertex, static_cast<int>(cells.points.size()));
      if (isNew)
      {
        cells.points.push_back(mesher::FromCgal(vertex->point()));
      }
      return found->second;
    };
    std::vector<SegmentSearch::Segment> segments;
    std::transform(this->Lines.begin(), this->Lines.end(), std::back_inserter(segments),
      [](const SegmentOnLine& line) {
        return SegmentSearch::Segment{ line.from, line.to };
      });
    const SegmentSearch search(segments);
    std::set<Crossing::Face_handle> done;
    for (const Crossing::Face_handle start : this->Triangles.finite_face_handles())
    {
      if (done.count(start) > 0)
      {
        continue;
      }
      const std::vector<Crossing::Face_handle> part = this->PartAt(start);
      done.insert(part.begin(), part.end());
      const int material = this->MaterialOf(part);
      for (const Crossing::Face_handle& face : part)
      {
        if (material < 0)
        {
          continue;
        }
        cells.cells.push_back(
          { numberOf(face->vertex(0)), numberOf(face->vertex(1)), numberOf(face->vertex(2)) });
        cells.materials.push_back(material);
        for (int i = 0; i < 3; ++i)
        {
          if (face->is_constrained(i))
          {
            const std::array<int, 2> points = { numberOf(face->vertex(Crossing::ccw(i))),
              numberOf(face->vertex(Crossing::cw(i))) };
            this->AddLine(search, points, cells);
          }
        }
      }
    }
    return cells;
  }

private:
  /// Moves points of lines that are near edges, or other lines, to them, and divides these there.
  void Attach()
  {
    std::map<Key, Point> moved;
    for (std::size_t i = 0; i < this->Lines.size(); ++i)
    {
      for (const Point& place : { this->Lines[i].from, this->Lines[i].to })
      {
        if (moved.count(KeyOf(place)) == 0)
        {
          Point target = place;
          if (!this->AttachTo(this->Edges, target))
          {
            this->AttachTo(this->Lines, target);
          }
          moved[KeyOf(place)] = target;
        }
      }
    }
    for (SegmentOnLine& line : this->Lines)
    {
      for (Point* const place : { &line.from, &line.to })
      {
        const auto found = moved.find(KeyOf(*place));
        *place = found == moved.end() ? *place : found->second;
      }
    }
  }

  /// Moves a place to the nearest of some segments that do not end there, if it is near, and divides it there.
  /// Returns whether there is one.
  template <class Segment>
  bool AttachTo(std::vector<Segment>& segments, Point& place) const
  {
    const double reach = SampledDistance * this->Extent;
    double smallest = reach;
    Segment* nearest = nullptr;
    for (Segment& segment : segments)
    {
      if (segment.from == place || segment.to == place)
      {
        continue;
      }
      const double distance = OffsetFromSegment(place, segment.from, segment.to).norm();
      if (distance <= smallest)
      {
        smallest = distance;
        nearest = &segment;
      }
    }
    if (nearest == nullptr)
    {
      return false;
    }
    for (const Point& end : { nearest->from, nearest->to })
    {
      if ((end - place).norm() <= reach)
      {
        place = end;
        return true;
      }
    }
    if (smallest > OnSegment * this->Extent)
    {
      place -= OffsetFromSegment(place, nearest->from, nearest->to);
    }
    Segment before = *nearest;
    before.to = nearest->from = place;
    segments.push_back(before);
    return true;
  }

  /// Divides lines near their ends that meet nothing: slits then have two sides, which are parallel nearly up to
  /// these ends.
  void DivideNearEnds()
  {
    std::map<Key, int> ends;
    const auto count = [&ends](const auto& segments)
    {
      for (const auto& segment : segments)
      {
        ++ends[KeyOf(segment.from)];
        ++ends[KeyOf(segment.to)];
      }
    };
    count(this->Edges);
    count(this->Lines);
    const std::size_t given = this->Lines.size();
    for (std::size_t i = 0; i < given; ++i)
    {
      for (const bool atStart : { true, false })
      {
        SegmentOnLine& line = this->Lines[i];
        const Point end = atStart ? line.from : line.to;
        if (ends[KeyOf(end)] != 1)
        {
          continue;
        }
        const Point along = atStart ? line.to - line.from : line.from - line.to;
        const double part = std::min(
          0.5, 10.0 * SlitWidth * this->Extent / along.norm()); // ten times as long as wide
        SegmentOnLine rest = line;
        rest.to = line.from = end + part * along;
        this->Lines.push_back(rest);
      }
    }
  }

  void Insert(const Point& from, const Point& to)
  {
    if (from != to)
    {
      this->Triangles.insert_constraint(mesher::ToCgal(from), mesher::ToCgal(to));
    }
  }

  /// Returns the triangles that no edge or line separates from one.
  std::vector<Crossing::Face_handle> PartAt(const Crossing::Face_handle& start) const
  {
    std::vector<Crossing::Face_handle> part = { start };
    std::set<Crossing::Face_handle> known = { start };
    for (std::size_t next = 0; next < part.size(); ++next)
    {
      const Crossing::Face_handle face = part[next];
      for (int i = 0; i < 3; ++i)
      {
        const Crossing::Face_handle other = face->neighbor(i);
        if (!face->is_constrained(i) && !this->Triangles.is_infinite(other) &&
          known.insert(other).second)
        {
          part.push_back(other);
        }
      }
    }
    return part;
  }

  /// Returns whether no edge separates a part from the outside.
  bool IsOutside(const std::vector<Crossing::Face_handle>& part) const
  {
    return std::any_of(part.begin(), part.end(),
      [this](const Crossing::Face_handle& face)
      {
        const std::array<int, 3> sides = { 0, 1, 2 };
        return std::any_of(sides.begin(), sides.end(),
          [&](int i)
          { return !face->is_constrained(i) && this->Triangles.is_infinite(face->neighbor(i)); });
      });
  }

  /// Returns the material of a part; −1 outside.
  int MaterialOf(const std::vector<Crossing::Face_handle>& part) const
  {
    if (this->IsOutside(part)) // also parts of no width beside edges that are divided
    {
      return -1;
    }
    Point place = Point::Zero();
    double largest = -1.0;
    for (const Crossing::Face_handle& face : part)
    {
      const Point a = mesher::FromCgal(face->vertex(0)->point());
      const Point b = mesher::FromCgal(face->vertex(1)->point());
      const Point c = mesher::FromCgal(face->vertex(2)->point());
      const double area = Cross(b - a, c - a);
      if (area > largest)
      {
        largest = area;
        place = (a + b + c) / 3.0;
      }
    }
    // The nearest edge on its right.
    double nearest = std::numeric_limits<double>::infinity();
    int material = -1;
    for (const MaterialEdge& edge : this->Edges)
    {
      if ((edge.from.y() > place.y()) == (edge.to.y() > place.y()))
      {
        continue;
      }
      const double x = edge.from.x() +
        (place.y() - edge.from.y()) / (edge.to.y() - edge.from.y()) * (edge.to.x() - edge.from.x());
      if (x > place.x() && x < nearest)
      {
        nearest = x;
        material = edge.to.y() > edge.from.y() ? edge.left : edge.right;
      }
    }
    return material;
  }

  /// Adds an edge to the lines if it is on one.
  void AddLine(
    const SegmentSearch& search, const std::array<int, 2>& points, MaterialCells& cells) const
  {
    const Point& from = cells.points[Index(points[0])];
    const Point& to = cells.points[Index(points[1])];
    const SegmentSearch::Nearest nearest = search.Find(0.5 * (from + to));
    if (std::sqrt(nearest.squaredDistance) > OnSegment * this->Extent)
    {
      return;
    }
    const SegmentOnLine& line = this->Lines[nearest.segment];
    LineEdge edge{ points, line.name };
    if ((to - from).dot(line.to - line.from) < 0.0)
    {
      std::reverse(edge.points.begin(), edge.points.end());
    }
    cells.lines.push_back(edge);
  }

  std::vector<MaterialEdge> Edges;
  std::vector<SegmentOnLine> Lines;
  double Extent = 0.0;
  Crossing Triangles;
};
}

std::vector<MaterialEdge> EdgesOf(const PlanarDomain& domain)
{
  std::vector<MaterialEdge> edges;
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      edges.push_back({ loop[i], loop[(i + 1) % loop.size()], 0, -1 });
    }
  }
  return edges;
}

std::vector<MaterialEdge> EdgesOf(const MaterialCells& cells)
{
  const CellSides sides(cells);
  std::vector<MaterialEdge> edges;
  for (const CellSide& side : sides.All())
  {
    const int left = cells.materials[Index(side.cell)];
    const int right = side.twin < 0 ? -1 : cells.materials[Index(sides[side.twin].cell)];
    if (left > right) // each edge once
    {
      edges.push_back({ sides.At(side.from), sides.At(side.to), left, right });
    }
  }
  return edges;
}

MaterialCells CellsAlongLines(const std::vector<MaterialEdge>& edges,
  std::vector<std::string> materials, const std::vector<SegmentOnLine>& lines,
  std::vector<std::string> lineNames)
{
  MaterialCells cells = LineTriangulation(edges, lines).Collect();
  cells.names = std::move(materials);
  cells.lineNames = std::move(lineNames);
  for (std::size_t name = 0; name < cells.lineNames.size(); ++name)
  {
    const bool isInside = std::any_of(cells.lines.begin(), cells.lines.end(),
      [name](const LineEdge& edge) { return Index(edge.name) == name; });
    if (!isInside)
    {
      throw Error("No part of the line '" + cells.lineNames[name] +
        "' is inside of the domain; move it, or leave it out.");
    }
  }
  return cells;
}
}
