#pragma once

#include "Alignment.h"
#include "ConstraintReduction.h"

namespace crossfield
{
/// Problem on the hole edges, reduced to the P1 Laplacian (docs/method.md §3.3, reduced form).
///
/// Let x be the values on the hole edges, with x_j on edge j counter-clockwise and vertex j between
/// edges j and j + 1. The conjugate potentials of Re u and Im u have sources s_j = x_j − x_{j+1} at
/// the hole vertices, s = ∇ᵀx, and the gradients of the constraints on the hole edges are f_j = Ψ_j
/// − Ψ_{j−1}, f = ∇Ψ. So the Schur complement of the Crouzeix-Raviart matrix on the hole edges is S
/// = ∇ K⁻¹ ∇ᵀ with the matrix K of PotentialOperator. The degree constraints do not change when a
/// constant is added to x on a hole. The energy is minimised over these constants, and S is
/// completed by the gauge that makes the mean of x on every hole zero.
///
/// If the potential has periods around holes, the constants matter: hole period k has the source
/// u(first edge of its strip) − x_last and acts on the last edge, so ∇ᵀ has an additional row
/// −x_last for it.
class PotentialReduction final : public ConstraintReduction
{
public:
  /// Reduces the problem, which must outlive this object. Throws Error when a hole has too few
  /// edges for its degree.
  explicit PotentialReduction(const PotentialProblem& problem,
    PotentialSolver::Periods periods = PotentialSolver::Periods::Islands);

  /// Returns the values in the gauge of the reduced problem.
  ComplexVector ValuesOf(const ComplexVector& u) const override;
  RecoveredField Recover(const ComplexVector& x) const override;

private:
  const PotentialProblem& Problem;
  PotentialSolver::Periods Periods;    ///< Whether constants on holes matter.
  std::vector<int> HoleEdges;          ///< Edge numbers, hole by hole, counter-clockwise.
  PotentialFactor::Eliminated Aligned; ///< Eliminated sources of aligned loops, columns Re and Im.
};
}
