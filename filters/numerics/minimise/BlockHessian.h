#pragma once

#include "BlockCholesky.h"
#include "ConstrainedMinimiser.h"
#include "DualProblem.h"

#include <utility>
#include <vector>

namespace crossfield
{
/// Adds a complex entry to the real matrix that acts on the real and imaginary parts.
void AddEntry(Eigen::MatrixXd& real, Eigen::Index row, Eigen::Index column, const Complex& value);

/// Returns the real matrix that acts on the real and imaginary parts as the complex matrix does.
Eigen::MatrixXd ToRealMatrix(const Eigen::MatrixXcd& matrix);

/// Second derivatives of the Lagrangian of a reduced problem and their factor, in block form and
/// without the weakest couplings between holes (docs/method.md §3.5).
class BlockHessian
{
public:
  explicit BlockHessian(DualProblem blocks);

  /// Factors (1 + shift) (S + margin × M) + Σ λ_i A_i + weight × N Nᵀ, where M is the bound of the
  /// couplings left out of S (DualProblem::MarginOfLeftOut). Constraint i is that of hole i.
  BlockCholesky<double> Factor(
    const ConstrainedFunctional::Additions& additions, double margin) const;

  /// Solves a system with such a factor; rows are ordered as in ConstrainedFunctional.
  Eigen::MatrixXd Solve(
    const BlockCholesky<double>& factor, const Eigen::MatrixXd& rightHandSides) const;

  /// Returns Nᵀ M⁻¹ N, where M is the matrix of such a factor.
  Eigen::MatrixXd Forms(
    const BlockCholesky<double>& factor, const Eigen::SparseMatrix<double>& normals) const;

private:
  /// Returns Σ A_i x in the bases; each hole has the rows of its own constraint.
  ComplexVector NormalsInBases(const Eigen::SparseMatrix<double>& normals) const;

  DualProblem Blocks;
  // The following matrices act on real and imaginary parts: S_ii and A_i of every hole in its
  // basis, and the couplings between holes.
  std::vector<Eigen::MatrixXd> Elastic;
  std::vector<Eigen::MatrixXd> Constraints;
  Eigen::MatrixXd Coupling;
  std::vector<Eigen::Index> CoupledParts;
};
}
