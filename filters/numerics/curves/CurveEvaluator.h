#pragma once

#include "CurveFrame.h"

namespace crossfield
{
/// Evaluates a curve that is not a line, with the parameter of FrameOf (docs/method.md §17.1).
/// Circles, ellipses and NURBS curves that end where they start are closed: their parameters are
/// periodic.
class CurveEvaluator
{
public:
  /// Throws Error if the curve is a line, has no extent, or its knots, points and weights do not
  /// match.
  explicit CurveEvaluator(PlaneCurve curve);

  const PlaneCurve& Curve() const { return this->Data; }
  bool IsClosed() const { return this->Closed; }
  /// Returns the first parameter.
  double First() const { return this->Start; }
  /// Returns the last parameter.
  double Last() const { return this->End; }
  double Period() const { return this->End - this->Start; }

  /// Returns the point at a parameter. On an open curve the parameter is limited to its range.
  Point At(double parameter) const;
  /// Returns position and derivatives.
  CurveFrame FrameAt(double parameter) const;
  /// Returns the unit tangent.
  Point Tangent(double parameter) const { return this->FrameAt(parameter).first.normalized(); }
  /// Returns the curvature, positive where the curve turns to the left.
  double Curvature(double parameter) const;

  /// Returns the parameter of the point nearest to a given one, to rounding: Newton's method on the
  /// derivative of the squared distance from the best of samples.
  double Nearest(const Point& place) const;
  /// Works as Nearest, but starts at a parameter and finds the point of the same part of the curve.
  double NearestFrom(const Point& place, double guess) const;
  /// Returns the parameter that is the given one plus a multiple of the period and nearest to
  /// another. At the start of a closed curve both ends are the same point.
  double Unwrap(double parameter, double near) const;

private:
  /// Consecutive samples in a circle.
  struct SampleBlock
  {
    std::size_t first = 0;
    std::size_t end = 0;
    Point centre = Point::Zero();
    double radius = 0.0;
  };

  double Limit(double parameter) const;
  void TakeSamples();
  void FormBlocks();
  /// Returns the samples from which the nearest point is searched for, at most three.
  std::vector<std::size_t> SamplesNear(const Point& place) const;
  /// Returns whether the tangent may jump at a sample.
  bool MayBeCorner(std::size_t sample) const;

  PlaneCurve Data;
  double Start = 0.0;
  double End = 0.0;
  bool Closed = true;
  double Extent = 0.0;            ///< Diagonal of the samples' bounding box.
  std::vector<double> Parameters; ///< Of the samples, increasing.
  std::vector<Point> Samples;
  std::vector<SampleBlock> Blocks; ///< Of about the square root of the number of samples.
  double Spacing = 0.0;            ///< Largest distance of consecutive samples.
};
}
