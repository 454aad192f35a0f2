#pragma once

#include "ConformingPhase.h"
#include "PotentialSolver.h"

namespace crossfield
{
/// The potential of a mesh without holes in the Crouzeix-Raviart space, with a value per edge. Its
/// energy is as far above the exact one as that of a potential with values at the vertices is below
/// it (docs/method.md §5.2, §5.3).
///
/// It is minus the conjugate of a piecewise linear phase with given growth along the boundary
/// (docs/method.md §2.2), so it is found with the DirichletSolver, which has a third of the
/// unknowns.
class EdgePotential
{
public:
  /// Stores a reference to `potential`, which must outlive this object.
  explicit EdgePotential(const PotentialSolver& potential)
    : Potential(potential)
    , Dirichlet(potential.GetDirichlet())
    , Steps(potential.GetOperator())
  {
  }

  /// Returns the potential at the midpoints of boundary edges for given fluxes through them, both
  /// in the order of mesh.boundary, any number of columns. It is single-valued, and 0 on the first
  /// edge of the outer loop. The fluxes of a column must add up to zero within rounding.
  Eigen::MatrixXd Solve(const Eigen::MatrixXd& fluxes) const;

  /// ∫ ∇φ_k · ∇φ_l, φ_k the harmonic phase that is 1 on inner loop k and 0 on the other loops: an
  /// upper bound of the exact matrix. The inverse of the Schur complement on the periods is a lower
  /// bound (docs/method.md §2.3).
  const Eigen::MatrixXd& CouplingOfIslands() const { return this->Dirichlet.IslandCoupling(); }

private:
  const PotentialSolver& Potential;
  const DirichletSolver& Dirichlet;
  ConformingPhase::Steps Steps;
};
}
