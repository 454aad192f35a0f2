#include "TMeshArcs.h"

#include "TMeshStops.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Builds the arcs between consecutive stops on separatrices and boundary loops.
class ArcBuilder
{
public:
  ArcBuilder(const SeamlessMap& map, const TraceGraph& graph)
    : Map(map)
    , Topology(*map.topology)
    , Walk(map)
    , Lines(graph.separatrices)
    , Stops(map, graph)
  {
    this->Mesh.separatrixCount = static_cast<int>(graph.separatrices.size());
    this->Mesh.extraSeparatrices = graph.extraSeparatrices;
    this->Mesh.headOn = graph.headOn;
    this->Mesh.crossings = this->Stops.CrossingCount();
    this->Mesh.ties = static_cast<int>(graph.ties.size());
    for (const TracedSeparatrix& line : this->Lines)
    {
      this->Mesh.longest = std::max(this->Mesh.longest, line.length);
    }
  }

  TMesh Build()
  {
    for (std::size_t i = 0; i < this->Lines.size(); ++i)
    {
      this->AddSeparatrix(i);
    }
    for (std::size_t l = 0; l < this->Topology.alignedVertices.size(); ++l)
    {
      this->AddLoop(static_cast<int>(l));
    }
    this->SetNodes();
    return std::move(this->Mesh);
  }

private:
  /// Takes the nodes that were not joined to others, and numbers the half-edges' nodes accordingly.
  void SetNodes()
  {
    const std::vector<TNode>& nodes = this->Stops.GetNodes();
    std::vector<int> number(nodes.size(), -1);
    for (int n = 0; n < static_cast<int>(nodes.size()); ++n)
    {
      if (this->Stops.Joined(n) == n)
      {
        number[n] = static_cast<int>(this->Mesh.nodes.size());
        this->Mesh.nodes.push_back(nodes[n]);
      }
    }
    for (THalfEdge& half : this->Mesh.halfEdges)
    {
      half.node = number[half.node];
    }
  }

  /// Adds an arc with its half-edges.
  void AddArc(TArc arc, const TMeshStop& from, const TMeshStop& to)
  {
    this->Mesh.arcs.push_back(std::move(arc));
    const auto add = [this](int node, int slot)
    {
      this->Mesh.halfEdges.push_back(
        { this->Stops.Joined(node), this->Stops.JoinedSlot(node, slot) });
    };
    add(from.node, from.forward);
    add(to.node, to.backward);
  }

  const SpacePoint& PlaceOf(const TMeshStop& stop) const
  {
    return this->Stops.GetNodes()[stop.node].place;
  }

  /// Returns the points where a separatrix passes from triangle to triangle, strictly between two
  /// lengths.
  std::vector<SpacePoint> Polyline(const TracedSeparatrix& line, double from, double to) const
  {
    std::vector<SpacePoint> points;
    for (const LineSegment& segment : line.segments)
    {
      if (segment.exitLength > from && segment.exitLength < to)
      {
        points.push_back(this->Walk.PlaceAt(segment.triangle, segment.exit));
      }
    }
    return points;
  }

  /// Adds the pieces of a separatrix between two lengths, triangle by triangle.
  static void AddPieces(
    const TracedSeparatrix& line, double from, double to, std::vector<ChartPiece>& pieces)
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

  /// Adds the pieces of an arc on a separatrix, or on two that meet head-on.
  void AddArcPieces(
    const TracedSeparatrix& line, double from, double to, std::vector<ChartPiece>& pieces) const
  {
    AddPieces(line, from, std::min(to, line.length), pieces);
    if (line.end == SeparatrixEnd::HeadOn)
    {
      const TracedSeparatrix& other = this->Lines[line.other];
      std::vector<ChartPiece> ofOther;
      AddPieces(
        other, line.headOnLength - to, std::min(line.headOnLength - from, other.length), ofOther);
      std::reverse(ofOther.begin(), ofOther.end());
      for (ChartPiece& piece : ofOther)
      {
        std::swap(piece.from, piece.to);
        piece.direction = (piece.direction + 2) % 4;
      }
      pieces.insert(pieces.end(), ofOther.begin(), ofOther.end());
    }
    if (pieces.empty())
    {
      // An arc of length zero has one piece, at its nodes.
      const LineSegment* at = &line.segments.front();
      for (const LineSegment& segment : line.segments)
      {
        at = segment.entryLength <= from ? &segment : at;
      }
      pieces.push_back({ at->triangle, at->direction, at->At(from), at->At(from) });
    }
  }

  /// Adds the arcs of a separatrix, or of two that meet head-on.
  void AddSeparatrix(std::size_t i)
  {
    const TracedSeparatrix& line = this->Lines[i];
    const bool both = line.end == SeparatrixEnd::HeadOn;
    const std::vector<TMeshStop> stops = this->Stops.OnSeparatrix(i);
    for (std::size_t j = 0; j + 1 < stops.size(); ++j)
    {
      TArc arc;
      arc.separatrix = static_cast<int>(i);
      arc.length = std::max(0.0, stops[j + 1].at - stops[j].at);
      const bool isClosed = stops[j].node == stops[j + 1].node && arc.length > 0.0;
      if (!isClosed && this->Stops.Joined(stops[j].node) == this->Stops.Joined(stops[j + 1].node))
      {
        continue; // its ends were joined
      }
      this->AddArcPieces(line, stops[j].at, stops[j + 1].at, arc.pieces);
      arc.polyline = { this->PlaceOf(stops[j]) };
      const auto add = [&arc](const std::vector<SpacePoint>& points)
      { arc.polyline.insert(arc.polyline.end(), points.begin(), points.end()); };
      add(this->Polyline(line, stops[j].at, std::min(stops[j + 1].at, line.length)));
      if (both)
      {
        const TracedSeparatrix& other = this->Lines[line.other];
        std::vector<SpacePoint> ofOther = this->Polyline(other, line.headOnLength - stops[j + 1].at,
          std::min(line.headOnLength - stops[j].at, other.length));
        std::reverse(ofOther.begin(), ofOther.end());
        add(ofOther);
      }
      arc.polyline.push_back(this->PlaceOf(stops[j + 1]));
      this->AddArc(std::move(arc), stops[j], stops[j + 1]);
    }
  }

  /// Adds the pieces of a loop between two lengths, edge by edge; the second length may be in the
  /// second lap around it.
  void AddBoundaryPieces(
    int loop, double loopLength, double from, double to, std::vector<ChartPiece>& pieces)
  {
    for (const double lap : { 0.0, loopLength })
    {
      double at = lap;
      for (const int vertex : this->Topology.alignedVertices[loop])
      {
        const int position = this->Stops.PositionAt(vertex);
        const auto [triangle, side] = this->Topology.SideOfBoundary(position);
        const Point& start = this->Map.At(triangle, side);
        const Point edge = this->Map.At(triangle, (side + 1) % 3) - start;
        const double length = edge.norm();
        const double a = std::max(from, at) - at;
        const double b = std::min(to, at + length) - at;
        if (b > a || (pieces.empty() && b == a && to == from))
        {
          pieces.push_back({ triangle, this->Map.directions[position], start + (a / length) * edge,
            start + (b / length) * edge, position });
        }
        at += length;
      }
    }
  }

  /// Adds the arcs of a boundary loop.
  void AddLoop(int loop)
  {
    // The stops around the loop, and its vertices, with their lengths along the loop.
    std::vector<TMeshStop> stops;
    std::vector<std::pair<double, SpacePoint>> vertices;
    double passed = 0.0;
    for (const int vertex : this->Topology.alignedVertices[loop])
    {
      const int position = this->Stops.PositionAt(vertex);
      const auto [triangle, side] = this->Topology.SideOfBoundary(position);
      vertices.emplace_back(passed, this->Topology.PositionOf(vertex));
      const double length =
        (this->Map.At(triangle, (side + 1) % 3) - this->Map.At(triangle, side)).norm();
      for (TMeshStop stop : this->Stops.OnEdge(position))
      {
        stop.at = passed + std::min(stop.at, length);
        stops.push_back(stop);
      }
      passed += length;
    }
    for (std::size_t j = 0; j < stops.size(); ++j)
    {
      const TMeshStop& from = stops[j];
      const TMeshStop& to = stops[(j + 1) % stops.size()];
      const bool isLast = j + 1 == stops.size();
      const double end = isLast ? to.at + passed : to.at;
      TArc arc;
      arc.onBoundary = true;
      arc.loop = loop;
      arc.length = end - from.at;
      this->AddBoundaryPieces(loop, passed, from.at, end, arc.pieces);
      arc.polyline = { this->PlaceOf(from) };
      for (const double lap : { 0.0, passed })
      {
        for (const auto& [at, point] : vertices)
        {
          if (at + lap > from.at && at + lap < end)
          {
            arc.polyline.push_back(point);
          }
        }
      }
      arc.polyline.push_back(this->PlaceOf(to));
      this->AddArc(std::move(arc), from, to);
    }
  }

  const SeamlessMap& Map;
  const MeshTopology& Topology;
  const LineWalk Walk;
  const std::vector<TracedSeparatrix>& Lines;
  const TMeshStops Stops;
  TMesh Mesh;
};
}

TMesh BuildArcs(const SeamlessMap& map, const TraceGraph& graph)
{
  return ArcBuilder(map, graph).Build();
}
}
