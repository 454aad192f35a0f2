#pragma once

#include "Error.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace crossfield
{
/// Error thrown for a matrix that is not positive definite.
class NotPositiveDefinite : public Error
{
public:
  NotPositiveDefinite()
    : Error("The matrix is not positive definite; the mesh may be in several parts or have "
            "degenerate triangles, remesh the domain.")
  {
  }
};

/// Supernodal Cholesky factorisation A = Pᵀ L Lᵀ P of a symmetric positive definite matrix by
/// CHOLMOD, in exactly the given elimination order.
class SparseCholesky
{
public:
  /// Factors the matrix. Only the lower triangle of `matrix` is read; `order[i]` is the unknown
  /// eliminated i-th. Throws Error when an entry is not finite, and NotPositiveDefinite when the
  /// matrix is not.
  SparseCholesky(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& order);
  /// Stores the order for Refactor, which must be called first.
  explicit SparseCholesky(const std::vector<int>& order);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// Replaces the factor by that of another matrix, in the same order. If the entries have the same
  /// places as in the last call, what depends on these only is not computed again. Throws as the
  /// constructor does; there is no factor after an error.
  void Refactor(const Eigen::SparseMatrix<double>& matrix);

  /// Solves A X = B column by column. Throws Error when the result is not finite.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& rightHandSides) const;

  /// Returns the lower triangular factor L_tt of the `count` trailing unknowns, the last ones of
  /// the order, in that order. L_tt L_ttᵀ is the Schur complement of A on them, which therefore
  /// requires no solve (docs/method.md §10.3).
  Eigen::MatrixXd TrailingFactor(int count) const;

private:
  struct Factor;

  void FactorFirst(const Eigen::SparseMatrix<double>& matrix);
  void RequirePositivePivots() const;

  std::unique_ptr<Factor> Data;
  std::vector<int> Order;
  std::vector<int> Starts; ///< Of the last call of Refactor: first entry of each column,
  std::vector<int> Rows;   ///< and row of each entry.
};
}
