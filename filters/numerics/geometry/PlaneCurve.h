#pragma once

#include "Plane.h"

#include <vector>

namespace crossfield
{
/// A curve of the plane as data: what a part of the boundary samples. A part of the boundary may be
/// only a piece of its curve, so arcs are circles and ellipses, too.
struct PlaneCurve
{
  enum class Kind
  {
    Line,    ///< The segments of the boundary themselves; nothing else is used.
    Circle,  ///< `centre` and the length of `axis`.
    Ellipse, ///< `centre`, a semi-axis `axis`, and `ratio`.
    Nurbs    ///< `degree`, `knots`, `points` and `weights`.
  };
  Kind kind = Kind::Line;
  Point centre = Point::Zero();
  Point axis = Point::Zero(); ///< From the centre to a point of the curve.
  double ratio = 1.0;         ///< The other semi-axis is `ratio` times `axis` turned by 90°.
  int degree = 3;
  std::vector<double> knots;   ///< Not decreasing; as many as `points` plus `degree` plus 1.
  std::vector<Point> points;   ///< Control points.
  std::vector<double> weights; ///< One for each control point, positive.
};
}
