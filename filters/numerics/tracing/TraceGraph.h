#pragma once

#include "Progress.h"
#include "Separatrices.h"

namespace crossfield
{
/// Traces the separatrices of a map. All advance together, the shortest first; where two cross, the
/// one that arrives later stops. If both arrive at the same time, both continue (SeparatrixTies.h).
/// Two on one isoline that meet head-on become one path. From each boundary loop that none meets,
/// one extra separatrix starts at a right angle.
TraceGraph TraceSeparatrices(const SeamlessMap& map, const Progress& progress = {});

/// Traces the straight line from a point of a triangle to the boundary, or up to length `longest`.
std::vector<LineSegment> TraceStreamline(
  const SeamlessMap& map, int triangle, const Point& w, int direction, double longest);
}
