#pragma once

#include "Plane.h"

#include <array>

namespace crossfield
{
/// Chains segments, given in any order and direction as pairs of point numbers, into closed loops.
///
/// A segment between a point and itself and a repeated segment count for nothing, so a polyline may
/// repeat its first point. The result depends on the point numbers only, not on the order of the
/// segments. Throws Error when a curve is open (a point with one segment), branches (more than two)
/// or a coordinate is not finite.
std::vector<Loop> ChainLoops(
  const std::vector<Point>& points, const std::vector<std::array<int, 2>>& segments);
}
