#include "TMeshArcs.h"

#include "Index.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace crossfield
{
namespace
{
/// A node on a line or loop.
struct Stop
{
  double at = 0.0;
  int node = 0;
  int forward = 0;  ///< Slots of the directions along the way
  int backward = 0; ///< and against it.
  int side = 0;     ///< Of a line that ends here: 1 from the left, 3 from the right of the way.
};

bool Before(const Stop& a, const Stop& b)
{
  return a.at < b.at;
}

class ArcLayer
{
public:
  ArcLayer(const SeamlessMap& map, const TraceGraph& graph)
    : Map(map)
    , Topology(*map.topology)
    , Walk(map)
    , Lines(graph.lines)
    , OnLine(graph.lines.size())
    , OnBoundary(map.topology->mesh.boundary.size())
  {
    this->Mesh.lineCount = static_cast<int>(graph.lines.size());
    this->Mesh.extraLines = graph.extraLines;
    this->Mesh.headOn = graph.headOn;
  }

  TMesh Lay()
  {
    this->PlaceCones();
    for (std::size_t i = 0; i < this->Lines.size(); ++i)
    {
      this->PlaceStart(i);
    }
    for (std::size_t i = 0; i < this->Lines.size(); ++i)
    {
      this->PlaceEnd(i);
      this->Mesh.longest = std::max(this->Mesh.longest, this->Lines[i].length);
    }
    this->Shift.assign(this->Mesh.nodes.size(), 0);
    this->Same.resize(this->Mesh.nodes.size());
    std::iota(this->Same.begin(), this->Same.end(), 0);
    for (std::size_t i = 0; i < this->Lines.size(); ++i)
    {
      this->JoinCrossings(this->StopsOn(i));
    }
    for (std::size_t i = 0; i < this->Lines.size(); ++i)
    {
      this->LayLine(i);
    }
    for (std::size_t l = 0; l < this->Topology.alignedVertices.size(); ++l)
    {
      this->LayLoop(static_cast<int>(l));
    }
    this->DropJoinedNodes();
    return std::move(this->Mesh);
  }

private:
  void DropJoinedNodes()
  {
    std::vector<int> number(this->Mesh.nodes.size(), -1);
    std::vector<TNode> kept;
    for (std::size_t n = 0; n < this->Mesh.nodes.size(); ++n)
    {
      if (this->Same[n] == static_cast<int>(n))
      {
        number[n] = static_cast<int>(kept.size());
        kept.push_back(this->Mesh.nodes[n]);
      }
    }
    this->Mesh.nodes = std::move(kept);
    for (THalfEdge& half : this->Mesh.halfEdges)
    {
      half.node = number[Index(half.node)];
    }
  }

  int AddNode(const TNode& node)
  {
    this->Mesh.nodes.push_back(node);
    return static_cast<int>(this->Mesh.nodes.size()) - 1;
  }

  /// The entry of mesh.boundary that starts at each vertex.
  int PositionAt(int vertex)
  {
    if (this->Positions.empty())
    {
      this->Positions.assign(this->Topology.mesh.points.size(), -1);
      for (std::size_t i = 0; i < this->Topology.mesh.boundary.size(); ++i)
      {
        this->Positions[Index(this->Topology.mesh.boundary[i].vertices[0])] = static_cast<int>(i);
      }
    }
    return this->Positions[Index(vertex)];
  }

  void PlaceCones()
  {
    for (std::size_t i = 0; i < this->Map.cones.size(); ++i)
    {
      const Cone& cone = this->Map.cones[i];
      const int node = this->AddNode({ cone.onBoundary ? NodeKind::Corner : NodeKind::Singularity,
        static_cast<int>(i), cone.Quarters(), this->Topology.PointAt(cone.vertex) });
      if (cone.onBoundary)
      {
        this->OnBoundary[Index(this->PositionAt(cone.vertex))].push_back(
          { 0.0, node, 0, cone.Quarters() });
      }
    }
  }

  /// How far a point of a boundary edge's chart is along it.
  double AlongEdge(int position, const Point& w) const
  {
    const auto [triangle, side] = this->SideOf(position);
    const Point way = w - this->Map.At(triangle, side);
    return std::max(0.0, TurnByQuarters(way, -this->Map.directions[Index(position)]).x());
  }

  std::pair<int, int> SideOf(int position) const
  {
    const int edge = this->Topology.EdgeOfBoundary(position);
    const int triangle = this->Topology.edges.triangles[Index(edge)][0];
    const auto& sides = this->Topology.edges.ofTriangle[Index(triangle)];
    return { triangle,
      static_cast<int>(std::find(sides.begin(), sides.end(), edge) - sides.begin()) };
  }

  int AddBoundaryNode(int position, const Point& w, const Point& place)
  {
    const int node = this->AddNode({ NodeKind::OnBoundary, -1, 2, place });
    this->OnBoundary[Index(position)].push_back({ this->AlongEdge(position, w), node, 0, 2 });
    return node;
  }

  void PlaceStart(std::size_t i)
  {
    const TracedLine& line = this->Lines[i];
    Stop start;
    start.node = line.cone;
    start.forward = line.slot;
    if (line.cone < 0)
    {
      const LineSegment& first = line.segments.front();
      start.node = this->AddBoundaryNode(
        line.startPosition, first.At(0.0), this->Walk.PlaneAt(first.triangle, first.entry));
      start.forward = 1;
    }
    this->OnLine[i].push_back(start);
  }

  void PlaceEnd(std::size_t i)
  {
    const TracedLine& line = this->Lines[i];
    const LineSegment& last = line.segments[Index(line.lastSegment)];
    Stop end;
    end.at = line.length;
    if (line.end == LineEnd::Boundary)
    {
      end.node = this->AddBoundaryNode(
        line.endPosition, last.At(line.length), this->Walk.PlaneAt(last.triangle, last.exit));
      end.backward = 1;
      this->OnLine[i].push_back(end);
    }
    else if (line.end == LineEnd::Line)
    {
      end.node = this->AddNode({ NodeKind::OnLine, -1, 4, this->Walk.PlaneAt(last, line.length) });
      end.backward = (line.endDirection + 2 - line.otherDirection + 4) % 4;
      this->OnLine[i].push_back(end);
      this->OnLine[Index(line.other)].push_back({ line.otherLength, end.node, 0, 2, end.backward });
    }
  }

  /// Slots count from the first node where several were joined.
  void AddArc(TArc arc, const Stop& from, const Stop& to)
  {
    this->Mesh.arcs.push_back(std::move(arc));
    const auto add = [this](int node, int slot)
    {
      const int shift = this->Shift[Index(node)];
      this->Mesh.halfEdges.push_back(
        { this->Same[Index(node)], shift == 0 ? slot : (slot + shift) % 4 });
    };
    add(from.node, from.forward);
    add(to.node, to.backward);
  }

  /// What a line passes through strictly between two lengths, and the ends.
  std::vector<Point> Polyline(const TracedLine& line, double from, double to) const
  {
    std::vector<Point> points;
    for (const LineSegment& segment : line.segments)
    {
      if (segment.exitLength > from && segment.exitLength < to)
      {
        points.push_back(this->Walk.PlaneAt(segment.triangle, segment.exit));
      }
    }
    return points;
  }

  /// The part of a line between two lengths, by triangles.
  static void AddPieces(
    const TracedLine& line, double from, double to, std::vector<ChartPiece>& pieces)
  {
    for (const LineSegment& segment : line.segments)
    {
      const double a = std::max(from, segment.entryLength);
      const double b = std::min(to, segment.exitLength);
      if (b > a)
      {
        pieces.push_back({ segment.triangle, segment.direction, segment.At(a), segment.At(b) });
      }
    }
  }

  /// The pieces of an arc on a line, or on two that met head-on.
  void LayPieces(
    const TracedLine& line, double from, double to, std::vector<ChartPiece>& pieces) const
  {
    AddPieces(line, from, std::min(to, line.length), pieces);
    if (line.end == LineEnd::HeadOn)
    {
      const TracedLine& other = this->Lines[Index(line.other)];
      std::vector<ChartPiece> rest;
      AddPieces(
        other, line.headOnLength - to, std::min(line.headOnLength - from, other.length), rest);
      std::reverse(rest.begin(), rest.end());
      for (ChartPiece& piece : rest)
      {
        std::swap(piece.from, piece.to);
        piece.direction = (piece.direction + 2) % 4;
      }
      pieces.insert(pieces.end(), rest.begin(), rest.end());
    }
    if (pieces.empty())
    {
      // An arc without length: the place of its nodes.
      const LineSegment* at = &line.segments.front();
      for (const LineSegment& segment : line.segments)
      {
        at = segment.entryLength <= from ? &segment : at;
      }
      pieces.push_back({ at->triangle, at->direction, at->At(from), at->At(from) });
    }
  }

  /// The nodes on a line, or on two that met head-on, from start to end; none of the second of those.
  std::vector<Stop> StopsOn(std::size_t i) const
  {
    const TracedLine& line = this->Lines[i];
    const bool both = line.end == LineEnd::HeadOn;
    if (both && line.other < static_cast<int>(i))
    {
      return {};
    }
    std::vector<Stop> stops = this->OnLine[i];
    if (both)
    {
      for (Stop stop : this->OnLine[Index(line.other)])
      {
        std::swap(stop.forward, stop.backward);
        stop.side = (stop.side + 2) % 4;
        stop.at = line.headOnLength - stop.at;
        stops.push_back(stop);
      }
    }
    std::stable_sort(stops.begin() + 1, stops.end(), Before);
    // What starts or ends it comes first or last, whatever rounding says.
    const int end = both ? this->OnLine[Index(line.other)].front().node : this->EndNode(i);
    const auto last = std::find_if(
      stops.begin() + 1, stops.end(), [end](const Stop& stop) { return stop.node == end; });
    if (last != stops.end())
    {
      std::rotate(last, last + 1, stops.end());
    }
    return stops;
  }

  /// Lines that end at one point of another one from both sides have one node. This is exact where
  /// the two would have met head-on, as those that follow a boundary without corners all around.
  void JoinCrossings(const std::vector<Stop>& stops)
  {
    const double tolerance = SameIsoline * this->Map.Extent();
    for (std::size_t j = 1; j + 2 < stops.size(); ++j)
    {
      const Stop& first = stops[j];
      const Stop& second = stops[j + 1];
      if (first.side % 2 == 1 && second.side % 2 == 1 && first.side != second.side &&
        second.at - first.at <= tolerance && this->Same[Index(first.node)] == first.node)
      {
        this->Same[Index(second.node)] = first.node;
        // A slot on the way is the slot of its frame plus the frame's first direction.
        this->Shift[Index(second.node)] = (first.forward - second.forward + 4) % 4;
        ++this->Mesh.crossings;
      }
    }
  }

  void LayLine(std::size_t i)
  {
    const TracedLine& line = this->Lines[i];
    const bool both = line.end == LineEnd::HeadOn;
    const std::vector<Stop> stops = this->StopsOn(i);
    for (std::size_t j = 0; j + 1 < stops.size(); ++j)
    {
      TArc arc;
      arc.line = static_cast<int>(i);
      if (this->Same[Index(stops[j].node)] == this->Same[Index(stops[j + 1].node)])
      {
        continue; // between two that were joined
      }
      arc.length = std::max(0.0, stops[j + 1].at - stops[j].at);
      this->LayPieces(line, stops[j].at, stops[j + 1].at, arc.pieces);
      arc.polyline = { this->Mesh.nodes[Index(stops[j].node)].place };
      const auto add = [&arc](const std::vector<Point>& points)
      { arc.polyline.insert(arc.polyline.end(), points.begin(), points.end()); };
      add(this->Polyline(line, stops[j].at, std::min(stops[j + 1].at, line.length)));
      if (both)
      {
        const TracedLine& other = this->Lines[Index(line.other)];
        std::vector<Point> rest = this->Polyline(other, line.headOnLength - stops[j + 1].at,
          std::min(line.headOnLength - stops[j].at, other.length));
        std::reverse(rest.begin(), rest.end());
        add(rest);
      }
      arc.polyline.push_back(this->Mesh.nodes[Index(stops[j + 1].node)].place);
      this->AddArc(std::move(arc), stops[j], stops[j + 1]);
    }
  }

  /// The node at the end of a line: PlaceEnd put it second but for those of others.
  int EndNode(std::size_t i) const
  {
    const auto& stops = this->OnLine[i];
    const auto found = std::find_if(stops.begin() + 1, stops.end(),
      [](const Stop& stop) { return stop.forward == 0 && stop.backward % 2 == 1; });
    return found == stops.end() ? -1 : found->node;
  }

  /// The part of a loop between two lengths, by edges; the second may be beyond the loop's start.
  void LayBoundaryPieces(
    int loop, double loopLength, double from, double to, std::vector<ChartPiece>& pieces)
  {
    for (const double turn : { 0.0, loopLength })
    {
      double at = turn;
      for (const int vertex : this->Topology.alignedVertices[Index(loop)])
      {
        const int position = this->PositionAt(vertex);
        const auto [triangle, side] = this->SideOf(position);
        const Point& start = this->Map.At(triangle, side);
        const Point edge = this->Map.At(triangle, (side + 1) % 3) - start;
        const double length = edge.norm();
        const double a = std::max(from, at) - at;
        const double b = std::min(to, at + length) - at;
        if (b > a || (pieces.empty() && b == a && to == from))
        {
          pieces.push_back({ triangle, this->Map.directions[Index(position)],
            start + (a / length) * edge, start + (b / length) * edge, position });
        }
        at += length;
      }
    }
  }

  void LayLoop(int loop)
  {
    // One chain of stops around the loop, and the vertices in between.
    std::vector<Stop> stops;
    std::vector<std::pair<double, Point>> vertices;
    double way = 0.0;
    for (const int vertex : this->Topology.alignedVertices[Index(loop)])
    {
      const int position = this->PositionAt(vertex);
      const auto [triangle, side] = this->SideOf(position);
      vertices.emplace_back(way, this->Topology.PointAt(vertex));
      const double length =
        (this->Map.At(triangle, (side + 1) % 3) - this->Map.At(triangle, side)).norm();
      std::vector<Stop>& own = this->OnBoundary[Index(position)];
      std::stable_sort(own.begin(), own.end(), Before);
      for (Stop stop : own)
      {
        stop.at = way + std::min(stop.at, length);
        stops.push_back(stop);
      }
      way += length;
    }
    for (std::size_t j = 0; j < stops.size(); ++j)
    {
      const Stop& from = stops[j];
      const Stop& to = stops[(j + 1) % stops.size()];
      const bool around = j + 1 == stops.size();
      const double end = around ? to.at + way : to.at;
      TArc arc;
      arc.onBoundary = true;
      arc.loop = loop;
      arc.length = end - from.at;
      this->LayBoundaryPieces(loop, way, from.at, end, arc.pieces);
      arc.polyline = { this->Mesh.nodes[Index(from.node)].place };
      for (const double turn : { 0.0, way })
      {
        for (const auto& [at, point] : vertices)
        {
          if (at + turn > from.at && at + turn < end)
          {
            arc.polyline.push_back(point);
          }
        }
      }
      arc.polyline.push_back(this->Mesh.nodes[Index(to.node)].place);
      this->AddArc(std::move(arc), from, to);
    }
  }

  const SeamlessMap& Map;
  const MeshTopology& Topology;
  const LineWalk Walk;
  const std::vector<TracedLine>& Lines;
  std::vector<std::vector<Stop>> OnLine;
  std::vector<std::vector<Stop>> OnBoundary; ///< Per entry of mesh.boundary.
  std::vector<int> Positions;
  std::vector<int> Same;  ///< Per node the one that it was joined to,
  std::vector<int> Shift; ///< and the slot there of its slot 0.
  TMesh Mesh;
};
}

TMesh LayArcs(const SeamlessMap& map, const TraceGraph& graph)
{
  return ArcLayer(map, graph).Lay();
}
}
