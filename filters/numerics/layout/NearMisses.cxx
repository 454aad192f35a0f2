#include "NearMisses.h"

#include "Index.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace crossfield
{
namespace
{
/// Where a vertex of the mesh is in the chart of one of its triangles.
const Point& PlaceIn(const SeamlessMap& map, int triangle, int vertex)
{
  const auto& corners = map.topology->mesh.triangles[Index(triangle)];
  const auto found = std::find(corners.begin(), corners.end(), vertex);
  return map.At(triangle, static_cast<int>(found - corners.begin()));
}

/// The way along a line to its end, and back along the other to its start; false where they do not share the last triangle.
bool Lay(const TracedLine& line, const TracedLine& other, NearMiss& miss)
{
  const int end = line.segments[Index(line.lastSegment)].triangle;
  for (int i = 0; i < line.lastSegment; ++i)
  {
    const LineSegment& segment = line.segments[Index(i)];
    miss.steps.push_back({ segment.triangle, segment.exit.side });
  }
  // The segment of the other line in that triangle where they meet: lines may pass a triangle more than once.
  int meeting = -1;
  double least = 0.0;
  for (int i = 0; i < static_cast<int>(other.segments.size()); ++i)
  {
    const LineSegment& segment = other.segments[Index(i)];
    const double off = std::max(
      { 0.0, segment.entryLength - line.otherLength, line.otherLength - segment.exitLength });
    if (segment.triangle == end && (meeting < 0 || off < least))
    {
      meeting = i;
      least = off;
    }
  }
  for (int i = meeting; i > 0; --i)
  {
    const LineSegment& segment = other.segments[Index(i)];
    miss.steps.push_back({ segment.triangle, segment.entry.side });
  }
  miss.firstTriangle = line.segments.front().triangle;
  miss.lastTriangle = other.segments.front().triangle;
  return meeting >= 0;
}
}

double NearMiss::Offset(const SeamlessMap& map) const
{
  const Point start =
    PlaceIn(map, this->firstTriangle, map.cones[static_cast<std::size_t>(this->from)].vertex);
  Point end =
    PlaceIn(map, this->lastTriangle, map.cones[static_cast<std::size_t>(this->to)].vertex);
  for (auto step = this->steps.rbegin(); step != this->steps.rend(); ++step)
  {
    end = map.Across(step->triangle, step->side)
            .Inverse()(end); // into the chart of the step's triangle
  }
  // Charts may have turned by quarters: along is where the way goes.
  Point way = end - start;
  for (int turn = 0; turn < 3 && !(way.x() > std::abs(way.y())); ++turn)
  {
    way = TurnByQuarters(way, 1);
  }
  return way.y();
}

std::vector<NearMiss> FindNearMisses(const TraceGraph& graph, double tolerance)
{
  std::vector<NearMiss> found;
  std::set<std::pair<int, int>> known; // a line, and the cone that it passes
  for (std::size_t i = 0; i < graph.separatrices.size(); ++i)
  {
    const TracedLine& line = graph.separatrices[i];
    if (line.cone < 0 || line.other < 0)
    {
      continue;
    }
    const TracedLine& other = graph.separatrices[Index(line.other)];
    NearMiss miss;
    miss.from = line.cone;
    miss.to = other.cone;
    miss.meets = line.end == LineEnd::HeadOn;
    const bool passes = miss.meets || (line.end == LineEnd::Line && line.otherLength <= tolerance);
    if (!passes || other.cone < 0 || other.cone == line.cone || !Lay(line, other, miss) ||
      known.count({ line.other, line.cone }) > 0 ||
      (miss.meets && line.other < static_cast<int>(i)))
    {
      continue;
    }
    miss.across = miss.meets ? 0.0 : line.otherLength;
    // The way along has to be longer than that across, or there is no telling which is which.
    if (miss.meets || line.length > 2.0 * line.otherLength)
    {
      found.push_back(std::move(miss));
    }
  }
  return found;
}
}
