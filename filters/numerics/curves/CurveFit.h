#pragma once

#include "PlaneCurve.h"

namespace crossfield
{
/// How points that a curve is fitted to are treated.
enum class FitEnds
{
  Free, ///< All points count the same.
  Fixed, ///< The curve leads through the first and the last point: they are corners, or ends of a side.
};

/// Returns the circle with the smallest sum of squared distances from points (docs/method.md §17.2).
/// Throws Error if there are fewer than three points, or they are on a line.
PlaneCurve FitCircle(const std::vector<Point>& points, FitEnds ends = FitEnds::Free);

/// Returns the ellipse with the smallest sum of squared distances from points. Throws Error if there
/// are fewer than five points, or no ellipse is near them.
PlaneCurve FitEllipse(const std::vector<Point>& points, FitEnds ends = FitEnds::Free);
}
