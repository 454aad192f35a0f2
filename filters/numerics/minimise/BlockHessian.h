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
  /// `leftOut` as in InBlocks.
  BlockHessian(const ReducedProblem& problem, double leftOut);

  /// Bound on the norm of what is left out of S.
  double LeftOut() const { return this->Blocks.leftOut; }

  /// The factor of (1 + shift) S + Σ λ_i A_i + weight × N Nᵀ + margin × the unit matrix. Constraint i is that of hole i.
  BlockCholesky<double> Factor(
    const ConstrainedFunctional::Additions& additions, double margin) const;

  /// Solves with such a factor; rows as those of ConstrainedFunctional.
  Eigen::MatrixXd Solve(
    const BlockCholesky<double>& factor, const Eigen::MatrixXd& rightHandSides) const;

private:
  DualProblem Blocks;
  Eigen::MatrixXd Coupling;
  std::vector<Eigen::Index> CoupledParts;
  std::vector<std::pair<std::size_t, int>>
    Place; ///< Of every unknown, its hole and its position there.
};
}
