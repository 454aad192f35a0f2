#pragma once

#include "SeamlessMap.h"
#include "TriangleFrames.h"

#include <vector>

namespace crossfield
{
/// The least-squares problem of a seamless map: minimise Σ A e^{2H} |∇w − e^{−(H + iθ)}|² over the
/// triangles of the cut mesh, A their areas (docs/method.md §12.3).
struct SeamlessPoisson
{
  std::vector<double> weights; ///< Per triangle, e^{2H}.
  /// Per triangle, the target of w at its corners, up to a constant.
  std::vector<Eigen::Matrix<double, 3, 2>> target;

  /// Returns minus half of the derivative of the sum with respect to u and v of every vertex. It is
  /// computed from differences within triangles, so its error is the rounding of these, however
  /// small they are compared with w.
  Eigen::MatrixX2d Residual(const SeamlessMap& map, const Eigen::VectorXd& unknowns) const;

  /// Returns the sum for unknowns as in EliminateSeams.
  double ObjectiveAt(const SeamlessMap& map, const Eigen::VectorXd& unknowns) const;

private:
  /// Returns the target minus the value of w at the corners of a triangle, up to a constant.
  Eigen::Matrix<double, 3, 2> DeviationIn(
    const SeamlessMap& map, const Eigen::VectorXd& unknowns, std::size_t triangle) const;
};

/// Returns the problem whose targets have the gradients of the frames; near a cone the target
/// is the local primitive of its singular part.
SeamlessPoisson TargetGradients(const MeshTopology& topology, const TriangleFrames& frames);

/// Raises weights below 1e-8 of the maximum, as if sizes differed by at most 1e4: weights that use
/// up the range of doubles would let rounding invert triangles (docs/method.md §12.3).
void LimitWeights(std::vector<double>& weights);
}
