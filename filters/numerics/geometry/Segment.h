#pragma once

#include "Plane.h"

#include <algorithm>

namespace crossfield
{
/// Returns the parameter of the point of a segment nearest to `point`: 0 at `from`, 1 at `to`. The
/// segment must have positive length.
inline double NearestFraction(const Point& point, const Point& from, const Point& to)
{
  const Point along = to - from;
  return std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
}

/// Returns the vector from the nearest point of a segment to `point`. Its norm is the distance.
inline Point OffsetFromSegment(const Point& point, const Point& from, const Point& to)
{
  return point - from - NearestFraction(point, from, to) * (to - from);
}
}
