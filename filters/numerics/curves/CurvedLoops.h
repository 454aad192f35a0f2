#pragma once

#include "BoundaryPieces.h"
#include "CurveEvaluator.h"

namespace crossfield
{
/// Parameters of the ends of a segment on its curve.
struct SegmentParameters
{
  double from = 0.0;
  double to = 0.0;
};

/// Returns the parameters of the points of a curve nearest to the ends of a segment, on the part of
/// the curve nearest to its middle.
SegmentParameters ParametersOf(const CurveEvaluator& curve, const Point& from, const Point& to);

/// Polylines along a boundary whose segments stand for pieces of curves: the point of the boundary at
/// an arc length of the polyline is that of the curve, whose parameter is linear on each segment
/// (docs/method.md §17.4). Where a curve begins or ends, it is the vertex of the polyline. Segments
/// without a curve stand for themselves.
class CurvedLoops
{
public:
  CurvedLoops() = default;
  /// `loops` have a vertex where a curve starts; others may be beside the curves.
  CurvedLoops(const CurvedBoundary& boundary, const std::vector<LoopArc>& loops);

  bool IsEmpty() const { return this->Evaluators.empty(); }
  /// Returns the index of the curve at an arc length, −1 if there is none.
  int CurveAt(const LoopArc& arc, std::size_t loop, double at) const;
  /// Returns the point at an arc length.
  Point At(const LoopArc& arc, std::size_t loop, double at) const;
  /// Returns the derivative of the point by the arc length of the polyline, nearly a unit vector; at
  /// a vertex, that on the segment after it.
  Point Derivative(const LoopArc& arc, std::size_t loop, double at) const;
  /// Returns the arc length of the point of the boundary nearest to a given one.
  double Nearest(const LoopArc& arc, std::size_t loop, const Point& place) const;

private:
  struct Segment
  {
    int curve = -1;
    SegmentParameters parameters;
    bool startsCurve = false; ///< Another curve, or none, ends at its start.
  };

  std::vector<CurveEvaluator> Evaluators;
  std::vector<std::vector<Segment>> Segments; ///< Per loop.
};
}
