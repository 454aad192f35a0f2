#pragma once

#include "LineWalk.h"
#include "Progress.h"

namespace crossfield
{
/// Lines this near, relative to the extent, are on one isoline: above what a solve is off by rounding
/// (1e-14 to 1e-13), and below what the lengths of opposite sides may differ by.
constexpr double SameIsoline = 4e-13;

/// What a line ends at.
enum class LineEnd
{
  None,     ///< It goes on.
  Line,     ///< The side of another line.
  Boundary, ///< The boundary.
  HeadOn    ///< The front of another line on the same isoline: both together are one way.
};

/// A straight line in a flat map, from where it starts to what stops it.
struct TracedLine
{
  int cone = -1; ///< Where it starts, in SeamlessMap::cones; −1: on the boundary (extra lines).
  int slot = 0;  ///< Which of the directions there, counter-clockwise from 0.
  int startPosition = -1; ///< Of an extra line: the entry of mesh.boundary where it starts.
  double delay = 0.0;     ///< Head start of the others, in length.
  double length = 0.0;    ///< In the map.
  LineEnd end = LineEnd::None;
  int other = -1;           ///< The line at its end,
  double otherLength = 0.0; ///< and where on that.
  /// Length of the way that two lines that meet head-on make together.
  double headOnLength = 0.0;
  int endPosition = -1;   ///< The entry of mesh.boundary where it ends.
  int lastSegment = 0;    ///< The segment that it ends in.
  int endDirection = 0;   ///< In the chart of that segment's triangle,
  int otherDirection = 0; ///< and that of the other line there.
  std::vector<LineSegment> segments;
};

/// All lines that leave the cones of a map, each up to the first line or side that it meets
/// (docs/method.md §13).
struct TraceGraph
{
  std::vector<TracedLine> lines;
  int extraLines = 0; ///< The last ones: for boundary loops that nothing meets.
  int headOn = 0;     ///< Pairs that met head-on.
};

/// Lines advance together, the shortest first; where two cross, the one that comes later stops. Lines
/// on one isoline that meet head-on become one. From each boundary loop that nothing meets one line is
/// drawn at right angles.
TraceGraph TraceLines(const SeamlessMap& map, const Progress& progress = {});

/// The straight line from a point of a triangle, as far as the boundary or a length.
std::vector<LineSegment> TraceStreamline(
  const SeamlessMap& map, int triangle, const Point& w, int direction, double longest);
}
