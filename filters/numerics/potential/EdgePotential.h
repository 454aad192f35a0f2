#pragma once

#include "PotentialSolver.h"

namespace crossfield
{
/// The potential of a mesh without holes in the Crouzeix-Raviart space, with a value per edge. Its energy is as far above the
/// exact one as that of a potential with values at the vertices is below it (docs/method.md §5.2, §5.3).
///
/// It is minus the conjugate of a piecewise linear phase with given growth along the boundary (docs/method.md §2.2), so it takes the
/// factor of the inner vertices, a third of the unknowns: PotentialSolver::OfGivenBoundary.
class EdgePotential
{
public:
  /// `potential` has natural boundaries, and has to outlive this.
  explicit EdgePotential(const PotentialSolver& potential)
    : Potential(potential)
    , Inside(potential.OfGivenBoundary())
    , Coupling(this->AroundIslands(this->Inside.IslandSources()))
  {
  }

  /// The potential at the midpoints of boundary edges for given fluxes through them, both in the order of mesh.boundary:
  /// single-valued, and 0 on the first edge of the outer loop. Fluxes add up to zero but for rounding.
  Eigen::VectorXd Solve(const Eigen::VectorXd& fluxes) const;

  /// ∫ ∇φ_k · ∇φ_l, φ_k the harmonic phase that is 1 on inner loop k and 0 on the other loops: an upper bound of what the
  /// inverse of the Schur complement on the periods bounds from below (docs/method.md §2.3).
  const Eigen::MatrixXd& CouplingOfIslands() const { return this->Coupling; }

private:
  /// Sums over the vertices of every inner loop: what the conjugate grows along it.
  Eigen::MatrixXd AroundIslands(const Eigen::MatrixXd& sources) const;

  const PotentialSolver& Potential;
  const PotentialSolver& Inside; ///< Of the inner vertices.
  Eigen::MatrixXd Coupling;      ///< See CouplingOfIslands.
};
}
