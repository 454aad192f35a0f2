#pragma once

#include "Error.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace crossfield
{
/// Thrown by SparseCholesky for a matrix that is not positive definite.
class NotPositiveDefinite : public Error
{
public:
  using Error::Error;
};

/// Supernodal Cholesky factorisation A = Pᵀ L Lᵀ P of a symmetric positive definite matrix by
/// CHOLMOD, in a given elimination order.
class SparseCholesky
{
public:
  /// `matrix` has both halves stored, `order[i]` is the unknown eliminated i-th. Throws Error when
  /// an entry is not finite, and NotPositiveDefinite when the matrix is not.
  SparseCholesky(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& order);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// Solves A X = B column by column. Throws Error when the result is not finite.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& rightHandSides) const;

  /// Lower triangular L_tt of the last `count` unknowns of the order, in that order. L_tt L_ttᵀ is
  /// the Schur complement of A on them, which therefore costs no solve (METHOD §3).
  Eigen::MatrixXd TrailingFactor(int count) const;

private:
  struct Factor;
  std::unique_ptr<Factor> Data;
};
}
