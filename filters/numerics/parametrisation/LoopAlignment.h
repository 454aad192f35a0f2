#pragma once

#include "MetricDerivatives.h"

namespace crossfield
{
/// Directions of the inner loops in a metric (docs/method.md §12.4): along a path of triangles from
/// the outer loop to an inner one, the direction of the sides in the charts should arrive at the
/// whole number of quarter turns that the chart there has for the loop. Around a handle (docs/method.md §22.9) the direction of
/// a side should arrive at itself, along two closed paths of triangles.
struct LoopAlignment
{
  /// Per inner loop, then per closed path, its direction minus the prescribed one, radians in (−π, π].
  Eigen::VectorXd defects;
  /// Their derivatives with respect to the logarithms of lengths, a sparse row for each.
  std::vector<std::vector<MetricDerivatives::Term>> rows;
  int innerLoops = 0;

  bool HasHandles() const { return static_cast<int>(this->rows.size()) > this->innerLoops; }

  /// Returns the derivative of all defects along a change of the logarithms.
  Eigen::VectorXd Changes(const Eigen::VectorXd& edges) const;
};

/// Measures the alignment along shortest paths of triangles. Any other paths give the same up to
/// multiples of the angle defects.
LoopAlignment MeasureAlignment(const MetricDerivatives& derivatives);
}
