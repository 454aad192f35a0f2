#pragma once

#include "Drawing.h"

#include <optional>
#include <vector>

namespace crossfield
{
/// Tangents at the ends of a spline; their lengths are not used.
struct EndTangents
{
  std::optional<Point> first;
  std::optional<Point> last;
};

/// Returns the cubic spline with chord-length parametrisation through points, as a NURBS curve with
/// three knots at each point. An end without a tangent is natural: its second derivative is 0. A
/// periodic spline ends where it starts, with the same two derivatives; its last point must equal
/// the first. Repeated points are ignored. Two different points yield a line.
DrawingPiece ThroughPoints(
  const std::vector<Point>& points, bool isPeriodic = false, const EndTangents& tangents = {});
}
