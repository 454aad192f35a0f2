#pragma once

#include "SeamlessMap.h"
#include "TriangleFrames.h"

#include <vector>

namespace crossfield
{
/// The least-squares problem Σ A e^{2H} |∇w − e^{−(H + iθ)}|² on the mesh of a map that is cut open
/// (docs/method.md §12.3).
struct SeamlessPoisson
{
  std::vector<double> weights; ///< Per triangle, e^{2H}.
  std::vector<Eigen::Matrix<double, 3, 2>>
    wanted; ///< Per triangle, w at its corners but for a constant.

  /// Minus half of the derivative of the sum, of u and v of every vertex. From the differences inside of triangles, so it is
  /// exact to rounding of these, however small they are beside w.
  Eigen::MatrixX2d Residual(const SeamlessMap& map, const Eigen::VectorXd& unknowns) const;

  /// The sum for unknowns as in EliminateSeams.
  double ObjectiveAt(const SeamlessMap& map, const Eigen::VectorXd& unknowns) const;

private:
  /// What is wanted less what is there of w at the corners of a triangle, but for a constant.
  Eigen::Matrix<double, 3, 2> Off(
    const SeamlessMap& map, const Eigen::VectorXd& unknowns, std::size_t triangle) const;
};

/// The weights, and what is wanted of the gradients, of the frames; near a logarithm by its local primitive.
SeamlessPoisson TargetGradients(const SeamlessMap& map, const TriangleFrames& frames);
}
