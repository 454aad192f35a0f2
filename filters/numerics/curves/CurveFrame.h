#pragma once

#include "PlaneCurve.h"

namespace crossfield
{
/// Highest degree of a NURBS curve; CAD programs write at most 25.
constexpr int MaximumDegree = 25;

/// Position on a curve with its first two derivatives by the parameter.
struct CurveFrame
{
  Point place = Point::Zero();
  Point first = Point::Zero();
  Point second = Point::Zero();
};

/// Returns the frame of a curve that is not a line (docs/method.md §17.1). The parameter of a circle
/// or an ellipse is the angle t of centre + cos t · axis + sin t · ratio · (axis turned by 90°); that
/// of a NURBS curve is the one of its knots, and is limited to their range.
CurveFrame FrameOf(const PlaneCurve& curve, double parameter);
}
