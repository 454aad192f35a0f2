#pragma once

#include "Plane.h"

#include <optional>
#include <vector>

namespace crossfield
{
/// A smooth curve through points: cubic Hermite interpolation over the length of the polyline, in
/// coordinates along and across the line from the first point to the last one (docs/method.md
/// §16.2). The curve is therefore the same in every position of the plane. Along the line, the
/// derivatives are the monotone ones of Fritsch and Butland, so the curve does not turn back; across
/// it, those of parabolas, so neighbouring curves differ smoothly.
class MonotoneCurve
{
public:
  /// Constructs the curve through at least two points that differ. `start`, if it is given, is the
  /// unit tangent at the first point.
  explicit MonotoneCurve(
    const std::vector<Point>& points, const std::optional<Point>& start = std::nullopt);

  /// Returns the arc length.
  double Length() const { return this->Lengths.back(); }
  /// Returns the point at an arc length between 0 and Length().
  Point At(double length) const;
  /// Returns the unit tangent at the first point.
  Point StartTangent() const;

private:
  /// Returns position and derivative on a piece, at a fraction of its chord.
  Point PlaceOn(std::size_t piece, double fraction) const;
  Point DerivativeOn(std::size_t piece, double fraction) const;
  /// Returns the arc length of a piece up to a fraction of its chord.
  double LengthOn(std::size_t piece, double fraction) const;

  std::vector<Point> Points;
  std::vector<double> Chords;  ///< Length of the chord of every piece.
  std::vector<Point> Slopes;   ///< Derivative at every point, with respect to the chord's length.
  std::vector<double> Lengths; ///< Arc length up to every point.
};
}
