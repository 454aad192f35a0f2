#pragma once

#include "Drawing.h"

#include "SplineThrough.h"

namespace crossfield
{
/// Returns the spline through points (SplineThrough). A periodic one ends where it starts, and its
/// last point must equal the first. Repeated points are ignored. Two different points yield a line.
DrawingPiece ThroughPoints(
  const std::vector<Point>& points, bool isPeriodic = false, const EndTangents& tangents = {});
}
