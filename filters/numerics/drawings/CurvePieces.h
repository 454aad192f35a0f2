#pragma once

#include "Drawing.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Returns an arc of a circle, counter-clockwise between two angles in degrees, exact at multiples
/// of 90°; the full circle if the angles are equal modulo 360°. Throws Error if the radius is not
/// positive; `origin` begins the message.
DrawingPiece ArcPiece(const Point& centre, double radius, double beginDegrees, double endDegrees,
  const std::string& origin);

/// Returns the arc from one point to another that turns by 4 atan(bulge), to the left if it is
/// positive; a line if it is 0.
DrawingPiece BulgePiece(const Point& first, const Point& last, double bulge);

/// Returns an arc of an ellipse between two parameters in radians (DrawingPiece::begin), in the
/// direction from `begin` to `end` by at most a full turn. Throws Error if an axis is not positive or
/// a parameter is beyond 1000.
DrawingPiece EllipsePiece(const Point& centre, const Point& axis, double ratio, double begin,
  double end, const std::string& origin);

/// Returns a NURBS curve over its range of knots; `weights` may be empty. Throws Error if numbers do
/// not match, knots decrease or a weight is not positive.
DrawingPiece NurbsPiece(int degree, std::vector<double> knots, std::vector<Point> points,
  std::vector<double> weights, const std::string& origin);

/// Returns the parts of a NURBS curve between its kinks, which are knots of full multiplicity where it
/// turns. The parts of a curve of degree 1 are lines.
std::vector<DrawingPiece> SplitAtKinks(const DrawingPiece& piece);

/// Returns a Bézier curve.
DrawingPiece BezierPiece(std::vector<Point> points);
}
