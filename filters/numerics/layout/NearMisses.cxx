#include "NearMisses.h"

#include "Index.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace crossfield
{
namespace
{
/// Returns the position of a vertex of the mesh in the chart of one of its triangles.
const Point& PositionInChart(const SeamlessMap& map, int triangle, int vertex)
{
  const auto& corners = map.topology->mesh.triangles[Index(triangle)];
  const auto found = std::find(corners.begin(), corners.end(), vertex);
  return map.At(triangle, static_cast<int>(found - corners.begin()));
}

/// Stores the path along a separatrix to its end, and back along the other one to its start.
/// Returns false if they do not share the last triangle.
bool StorePath(const TracedSeparatrix& line, const TracedSeparatrix& other, NearMiss& miss)
{
  const int end = line.segments[Index(line.lastSegment)].triangle;
  for (int i = 0; i < line.lastSegment; ++i)
  {
    const LineSegment& segment = line.segments[Index(i)];
    miss.steps.push_back({ segment.triangle, segment.exit.side });
  }
  // The segment of the other separatrix in that triangle at which they meet: a separatrix may pass
  // a triangle more than once.
  int meeting = -1;
  double smallest = 0.0;
  for (int i = 0; i < static_cast<int>(other.segments.size()); ++i)
  {
    const LineSegment& segment = other.segments[Index(i)];
    const double mismatch = std::max(
      { 0.0, segment.entryLength - line.otherLength, line.otherLength - segment.exitLength });
    if (segment.triangle == end && (meeting < 0 || mismatch < smallest))
    {
      meeting = i;
      smallest = mismatch;
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
  const Point start = PositionInChart(
    map, this->firstTriangle, map.cones[static_cast<std::size_t>(this->from)].vertex);
  Point end =
    PositionInChart(map, this->lastTriangle, map.cones[static_cast<std::size_t>(this->to)].vertex);
  for (auto step = this->steps.rbegin(); step != this->steps.rend(); ++step)
  {
    end = map.Across(step->triangle, step->side)
            .Inverse()(end); // into the chart of the triangle of this step
  }
  // Charts may be rotated by quarter turns; the first coordinate is the direction of the path.
  Point path = end - start;
  for (int turn = 0; turn < 3 && !(path.x() > std::abs(path.y())); ++turn)
  {
    path = TurnByQuarters(path, 1);
  }
  return path.y();
}

std::vector<NearMiss> FindNearMisses(const TraceGraph& graph, double tolerance)
{
  std::vector<NearMiss> found;
  std::set<std::pair<int, int>> known; // separatrix and the cone that it passes
  for (std::size_t i = 0; i < graph.separatrices.size(); ++i)
  {
    const TracedSeparatrix& line = graph.separatrices[i];
    if (line.cone < 0 || line.other < 0)
    {
      continue;
    }
    const TracedSeparatrix& other = graph.separatrices[Index(line.other)];
    NearMiss miss;
    miss.from = line.cone;
    miss.to = other.cone;
    miss.meets = line.end == SeparatrixEnd::HeadOn;
    const bool passes =
      miss.meets || (line.end == SeparatrixEnd::Line && line.otherLength <= tolerance);
    if (!passes || other.cone < 0 || other.cone == line.cone || !StorePath(line, other, miss) ||
      known.count({ line.other, line.cone }) > 0 ||
      (miss.meets && line.other < static_cast<int>(i)))
    {
      continue;
    }
    miss.across = miss.meets ? 0.0 : line.otherLength;
    // The distance along the separatrix must be longer than the transverse one, otherwise the two
    // cannot be distinguished.
    if (miss.meets || line.length > 2.0 * line.otherLength)
    {
      found.push_back(std::move(miss));
    }
  }
  return found;
}
}
