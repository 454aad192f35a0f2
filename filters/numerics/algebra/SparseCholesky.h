#pragma once

#include "Error.h"

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace crossfield
{
/// Thrown for a matrix that is not positive definite.
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
/// CHOLMOD, in exactly the elimination order given.
class SparseCholesky
{
public:
  /// Only the lower half of `matrix` is read, `order[i]` is the unknown eliminated i-th. Throws Error when
  /// an entry is not finite, and NotPositiveDefinite when the matrix is not.
  SparseCholesky(const Eigen::SparseMatrix<double>& matrix, const std::vector<int>& order);
  ~SparseCholesky();
  SparseCholesky(const SparseCholesky&) = delete;
  SparseCholesky& operator=(const SparseCholesky&) = delete;

  /// How many factorisations this process has begun: by it tests see that what is factored is kept.
  static long CountOfAll();

  /// Solves A X = B column by column. Throws Error when the result is not finite.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& rightHandSides) const;

  /// The two halves of Solve: L⁻¹ P B and Pᵀ L⁻ᵀ B. Rows of the result of the first, and of the
  /// argument of the second, are in elimination order.
  Eigen::MatrixXd SolveLower(const Eigen::MatrixXd& rightHandSides) const;
  Eigen::MatrixXd SolveUpper(const Eigen::MatrixXd& rightHandSides) const;

  /// Rows of a matrix, from a first one on.
  struct Rows
  {
    int first;
    Eigen::MatrixXd values;
  };
  /// L⁻¹ B for every B of some with few entries: of each, the rows that are not zero, supernode by supernode. They lie on the
  /// ways of the elimination tree from its entries to the root. Rows of B and of the result are in elimination order.
  std::vector<std::vector<Rows>> SolveLowerSparse(
    const std::vector<Eigen::SparseMatrix<double>>& blocks) const;

  /// Lower triangular L_tt of the `count` trailing unknowns, the last of the order, in that order.
  /// L_tt L_ttᵀ is the Schur complement of A on them, which therefore costs no solve
  /// (docs/method.md §10.3).
  Eigen::MatrixXd TrailingFactor(int count) const;

private:
  struct Factor;

  /// cholmod_solve with one of its kinds of system.
  Eigen::MatrixXd Solve(int system, const Eigen::MatrixXd& rightHandSides) const;

  std::unique_ptr<Factor> Data;
};
}
