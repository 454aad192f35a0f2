#pragma once

#include "FlatMap.h"
#include "Progress.h"
#include "TriangleFrames.h"

#include <Eigen/SparseCore>

#include <vector>

namespace crossfield
{
/// The least-squares problem Σ A e^{2H} |∇w − e^{−(H + iθ)}|² on the mesh of a map that is cut open
/// (docs/method.md §12.3).
struct SeamlessPoisson
{
  Eigen::SparseMatrix<double> matrix; ///< Of u, and of v.
  Eigen::MatrixX2d sources;
  double constant = 0.0;
  std::vector<double> weights; ///< Per triangle, e^{2H}.
  std::vector<Eigen::Matrix<double, 3, 2>>
    wanted; ///< Per triangle, w at its corners but for a constant.

  /// Minus half of the derivative of the sum, of u and v of every vertex. From the differences inside of triangles, so it is
  /// exact to rounding of these, however small they are beside w.
  Eigen::MatrixX2d Residual(const FlatMap& map, const Eigen::VectorXd& unknowns) const;

  /// The sum for unknowns as in EliminateSeams.
  double Misfit(const Eigen::VectorXd& unknowns) const;
};

SeamlessPoisson AssemblePoisson(const FlatMap& map, const TriangleFrames& frames);

/// The unknowns u and v of every vertex, then the translations, in terms of the free ones of
/// EliminateSeams: one Cholesky factorisation.
Eigen::VectorXd SolveSeamless(const FlatMap& map, const SeamlessPoisson& poisson,
  const Eigen::SparseMatrix<double, Eigen::RowMajor>& prolongation, const Progress& progress = {});
}
