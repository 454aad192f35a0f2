#pragma once

#include "Plane.h"

#include <algorithm>

namespace crossfield
{
/// Where on a segment of positive length the place nearest to a point is: 0 at `from`, 1 at `to`.
inline double NearestFraction(const Point& point, const Point& from, const Point& to)
{
  const Point along = to - from;
  return std::clamp((point - from).dot(along) / along.squaredNorm(), 0.0, 1.0);
}

/// The way to a point from the place of a segment that is nearest to it; its norm is the distance.
inline Point WayFromSegment(const Point& point, const Point& from, const Point& to)
{
  return point - from - NearestFraction(point, from, to) * (to - from);
}
}
