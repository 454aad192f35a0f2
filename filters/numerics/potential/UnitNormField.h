#pragma once

#include "Alignment.h"

namespace crossfield
{
/// The cross field with |u| = 1 of least ½ ∫ |∇φ|², u = e^{iφ}, aligned on every outer and inner
/// loop and turning d_i times around hole i (docs/method.md §2.5; paper, "How to evaluate the choice of a
/// singularity location").
struct UnitNormField
{
  ComplexVector u;     ///< Per edge; exactly unit and exactly aligned.
  double energy = 0.0; ///< ½ ∫ |∇φ|² = ½ ∫ |∇Φ|² of its conjugate potential.
  /// Largest |u − e^{4iτ}| over the aligned edges before they were set: what rounding and the
  /// linear solver left of the boundary condition.
  double residual = 0.0;
  /// Per inner loop, in (−π, π]: the phase that the single-valued potential carries to it minus the
  /// phase of its alignment. Where it is not zero a harmonic field with a period was added.
  std::vector<double> holonomyDefect;
  Eigen::VectorXd potential; ///< Φ at the vertices, then its periods around inner loops.
};

/// Computed from the conjugate potential Φ of SolveAligned, with a phase that is constant along every
/// edge of the boundary.
UnitNormField SolveUnitNorm(const PotentialProblem& problem);
}
