#include "TMeshStops.h"

#include "Index.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace crossfield
{
namespace
{
bool IsBefore(const TMeshStop& a, const TMeshStop& b)
{
  return a.at < b.at;
}
}

TMeshStops::TMeshStops(const SeamlessMap& map, const TraceGraph& graph)
  : Map(map)
  , Topology(*map.topology)
  , Walk(map)
  , Lines(graph.separatrices)
  , OnLines(graph.separatrices.size())
  , OnBoundary(map.topology->mesh.boundary.size())
  , Positions(Index(map.topology->VertexCount()), -1)
{
  for (std::size_t i = 0; i < this->Topology.mesh.boundary.size(); ++i)
  {
    this->Positions[this->Topology.mesh.boundary[i].vertices[0]] = static_cast<int>(i);
  }
  this->AddCones();
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    this->AddStart(i);
  }
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    this->AddEnd(i);
  }
  for (const SeparatrixTie& tie : graph.ties)
  {
    this->AddTie(tie);
  }
  for (std::vector<TMeshStop>& stops : this->OnBoundary)
  {
    std::stable_sort(stops.begin(), stops.end(), IsBefore);
  }
  this->Shift.assign(this->Nodes.size(), 0);
  this->Same.resize(this->Nodes.size());
  std::iota(this->Same.begin(), this->Same.end(), 0);
  for (std::size_t i = 0; i < this->Lines.size(); ++i)
  {
    this->JoinCrossings(this->OnSeparatrix(i));
  }
}

int TMeshStops::AddNode(const TNode& node)
{
  this->Nodes.push_back(node);
  return static_cast<int>(this->Nodes.size()) - 1;
}

void TMeshStops::AddCones()
{
  for (std::size_t i = 0; i < this->Map.cones.size(); ++i)
  {
    const Cone& cone = this->Map.cones[i];
    const int node = this->AddNode({ cone.onBoundary ? NodeKind::Corner : NodeKind::Singularity,
      static_cast<int>(i), cone.Quarters(), this->Topology.PositionOf(cone.vertex) });
    if (cone.onBoundary)
    {
      this->OnBoundary[this->PositionAt(cone.vertex)].push_back({ 0.0, node, 0, cone.Quarters() });
    }
  }
}

double TMeshStops::AlongEdge(int position, const Point& w) const
{
  const auto [triangle, side] = this->Topology.SideOfBoundary(position);
  const Point offset = w - this->Map.At(triangle, side);
  return std::max(0.0, TurnByQuarters(offset, -this->Map.directions[position]).x());
}

int TMeshStops::AddBoundaryNode(int position, const Point& w, const SpacePoint& place)
{
  const int node = this->AddNode({ NodeKind::OnBoundary, -1, 2, place });
  this->OnBoundary[position].push_back({ this->AlongEdge(position, w), node, 0, 2 });
  return node;
}

void TMeshStops::AddStart(std::size_t i)
{
  const TracedSeparatrix& line = this->Lines[i];
  TMeshStop start;
  start.node = line.cone;
  start.forward = line.slot;
  if (line.cone < 0)
  {
    const LineSegment& first = line.segments.front();
    start.node = this->AddBoundaryNode(
      line.startPosition, first.At(0.0), this->Walk.PlaceAt(first.triangle, first.entry));
    start.forward = 1;
  }
  this->OnLines[i].push_back(start);
}

void TMeshStops::AddEnd(std::size_t i)
{
  const TracedSeparatrix& line = this->Lines[i];
  const LineSegment& last = line.segments[line.lastSegment];
  TMeshStop end;
  end.at = line.length;
  if (line.end == SeparatrixEnd::Boundary)
  {
    end.node = this->AddBoundaryNode(
      line.endPosition, last.At(line.length), this->Walk.PlaceAt(last.triangle, last.exit));
    end.backward = 1;
    this->OnLines[i].push_back(end);
  }
  else if (line.end == SeparatrixEnd::Line)
  {
    end.node =
      this->AddNode({ NodeKind::OnSeparatrix, -1, 4, this->Walk.PlaceAt(last, line.length) });
    end.backward = (line.endDirection + 2 - line.otherDirection + 4) % 4;
    this->OnLines[i].push_back(end);
    this->OnLines[line.other].push_back({ line.otherLength, end.node, 0, 2, end.backward });
  }
}

void TMeshStops::AddTie(const SeparatrixTie& tie)
{
  const LineSegment& first = this->Lines[tie.lines[0]].segments[tie.segments[0]];
  const LineSegment& second = this->Lines[tie.lines[1]].segments[tie.segments[1]];
  const int node =
    this->AddNode({ NodeKind::OnSeparatrix, -1, 4, this->Walk.PlaceAt(first, tie.lengths[0]) });
  const int turn = (second.direction - first.direction + 4) % 4;
  this->OnLines[tie.lines[0]].push_back({ tie.lengths[0], node, 0, 2 });
  this->OnLines[tie.lines[1]].push_back({ tie.lengths[1], node, turn, (turn + 2) % 4 });
}

int TMeshStops::EndNode(std::size_t i) const
{
  const auto& stops = this->OnLines[i];
  const auto found = std::find_if(stops.begin() + 1, stops.end(),
    [](const TMeshStop& stop) { return stop.forward == 0 && stop.backward % 2 == 1; });
  return found == stops.end() ? -1 : found->node;
}

std::vector<TMeshStop> TMeshStops::OnSeparatrix(std::size_t i) const
{
  const TracedSeparatrix& line = this->Lines[i];
  const bool both = line.end == SeparatrixEnd::HeadOn;
  if (both && line.other < static_cast<int>(i))
  {
    return {};
  }
  std::vector<TMeshStop> stops = this->OnLines[i];
  if (both)
  {
    for (TMeshStop stop : this->OnLines[line.other])
    {
      std::swap(stop.forward, stop.backward);
      stop.side = (stop.side + 2) % 4;
      stop.at = line.headOnLength - stop.at;
      stops.push_back(stop);
    }
  }
  std::stable_sort(stops.begin() + 1, stops.end(), IsBefore);
  // The first and the last stop are its ends, whatever rounding makes of their lengths.
  const int end = both ? this->OnLines[line.other].front().node : this->EndNode(i);
  const auto last = std::find_if(
    stops.begin() + 1, stops.end(), [end](const TMeshStop& stop) { return stop.node == end; });
  if (last != stops.end())
  {
    std::rotate(last, last + 1, stops.end());
  }
  return stops;
}

void TMeshStops::JoinCrossings(const std::vector<TMeshStop>& stops)
{
  const double tolerance = SameIsoline * this->Map.Extent();
  for (std::size_t j = 1; j + 2 < stops.size(); ++j)
  {
    const TMeshStop& first = stops[j];
    const TMeshStop& second = stops[j + 1];
    if (first.side % 2 == 1 && second.side % 2 == 1 && first.side != second.side &&
      second.at - first.at <= tolerance && this->Same[first.node] == first.node)
    {
      this->Same[second.node] = first.node;
      // Slots at both nodes count from the path; the difference aligns their first directions.
      this->Shift[second.node] = (first.forward - second.forward + 4) % 4;
      ++this->Crossings;
    }
  }
}
}
