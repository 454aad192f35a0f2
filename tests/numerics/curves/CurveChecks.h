#pragma once

#include "CurveEvaluator.h"

#include <algorithm>
#include <vector>

namespace crossfield::test
{
/// Returns points of a curve at `count` even parameters.
inline std::vector<Point> PointsOn(const CurveEvaluator& curve, double from, double to, int count)
{
  std::vector<Point> points;
  for (int i = 0; i < count; ++i)
  {
    points.push_back(curve.At(from + (to - from) * i / (count - 1)));
  }
  return points;
}

/// Returns the largest distance of points from a curve.
inline double LargestDistance(const CurveEvaluator& curve, const std::vector<Point>& points)
{
  double largest = 0.0;
  for (const Point& point : points)
  {
    largest = std::max(largest, (curve.At(curve.Nearest(point)) - point).norm());
  }
  return largest;
}
}
