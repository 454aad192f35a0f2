#pragma once

#include "BlockCholesky.h"
#include "ConstrainedMinimiser.h"
#include "DualProblem.h"

#include <utility>
#include <vector>

namespace crossfield
{
/// Adds a complex entry to the real matrix that acts on the parts.
void AddEntry(Eigen::MatrixXd& real, Eigen::Index row, Eigen::Index column, const Complex& value);

/// The real matrix that acts on the parts as a complex one does.
Eigen::MatrixXd OnParts(const Eigen::MatrixXcd& matrix);

/// Second derivatives of the Lagrangian of a reduced problem and their factor, in blocks, without the weakest
/// couplings between holes (docs/method.md §3.5).
class BlockHessian
{
public:
  explicit BlockHessian(DualProblem blocks);

  /// The factor of (1 + shift) (S + margin × M) + Σ λ_i A_i + weight × N Nᵀ, M the bound of what is left out of S
  /// (DualProblem::MarginOfLeftOut). Constraint i is that of hole i.
  BlockCholesky<double> Factor(
    const ConstrainedFunctional::Additions& additions, double margin) const;

  /// Solves with such a factor; rows as those of ConstrainedFunctional.
  Eigen::MatrixXd Solve(
    const BlockCholesky<double>& factor, const Eigen::MatrixXd& rightHandSides) const;

  /// Nᵀ M⁻¹ N with the M of such a factor.
  Eigen::MatrixXd Forms(
    const BlockCholesky<double>& factor, const Eigen::SparseMatrix<double>& normals) const;

private:
  /// Σ A_i x in the bases: every hole has the rows of its own constraint.
  ComplexVector NormalsInBases(const Eigen::SparseMatrix<double>& normals) const;

  DualProblem Blocks;
  // These act on the parts: of every hole, S_ii and A_i in its basis, and what couples them.
  std::vector<Eigen::MatrixXd> Elastic;
  std::vector<Eigen::MatrixXd> Constraints;
  Eigen::MatrixXd Coupling;
  std::vector<Eigen::Index> CoupledParts;
};
}
