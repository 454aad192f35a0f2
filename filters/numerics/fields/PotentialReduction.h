#pragma once

#include "Alignment.h"
#include "ConstraintReduction.h"

namespace crossfield
{
/// The problem on the hole edges, reduced to the P1 Laplacian (docs/method.md §3.3, reduced form).
///
/// With x the values on the hole edges, x_j on edge j counter-clockwise and vertex j between edges j
/// and j + 1, the conjugate potentials of Re u and Im u have sources s_j = x_j − x_{j+1} at the hole
/// vertices, s = ∇ᵀx, and the forces of the constraints on the hole edges are f_j = Ψ_j − Ψ_{j−1},
/// f = ∇Ψ. So the Schur complement of the Crouzeix-Raviart matrix on the hole edges is
/// S = ∇ K⁻¹ ∇ᵀ with the matrix K of PotentialSolver. The degree constraints do
/// not change when a constant is added to x on a hole: the energy is minimised over these constants,
/// and S is completed by the gauge that makes the mean of x on every hole zero.
///
/// If the potential has periods around holes, the constants count: hole period k has the source
/// u(first edge of its strip) − x_last and acts on the last edge, so ∇ᵀ gets a row −x_last for it.
class PotentialReduction final : public ConstraintReduction
{
public:
  /// Refers to the problem. Throws Error when a hole has too few edges for its degree.
  explicit PotentialReduction(const PotentialProblem& problem,
    PotentialSolver::Periods periods = PotentialSolver::Periods::Islands);

  /// In the gauge of the reduced problem.
  ComplexVector ValuesOf(const ComplexVector& u) const override;
  RecoveredField Recover(const ComplexVector& x) const override;

private:
  const PotentialProblem& Problem;
  PotentialSolver::Periods Periods;    ///< With those of holes, constants on holes count.
  std::vector<int> HoleEdges;          ///< Edge numbers, hole by hole, counter-clockwise.
  PotentialFactor::Eliminated Aligned; ///< Of the sources of aligned loops, columns Re and Im.
};
}
