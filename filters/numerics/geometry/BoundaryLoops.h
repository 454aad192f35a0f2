#pragma once

#include "Plane.h"

#include <array>

namespace crossfield
{
/// Chains segments, given as pairs of point indices in any order and direction, into closed loops.
///
/// Degenerate and repeated segments are ignored, so a polyline may repeat its first point. The
/// result depends only on the point indices, not on the order of the segments. Throws Error if a
/// curve is open (a point with one segment), if it branches (more than two) or if a coordinate is
/// not finite.
std::vector<Loop> ChainLoops(
  const std::vector<Point>& points, const std::vector<std::array<int, 2>>& segments);
}
