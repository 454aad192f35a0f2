#pragma once

#include "PlaneCurve.h"

#include <optional>

namespace crossfield
{
/// Directions of an open spline at its ends; their lengths are not used.
struct EndTangents
{
  std::optional<Point> first;
  std::optional<Point> last;
};

/// Returns the cubic spline through points, parametrised by the length of its chords, as a NURBS curve
/// with three knots at each point (docs/method.md §17.2). A closed one is periodic and returns to the
/// first point. At an open end without a tangent the third derivative is continuous at the point next
/// to it. There must be at least two points, three if it is closed, and neighbours must differ.
PlaneCurve SplineThrough(
  const std::vector<Point>& points, bool isClosed, const EndTangents& tangents = {});
}
