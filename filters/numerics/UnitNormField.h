#pragma once

#include "PerforatedProblem.h"

namespace crossfield
{
/// The cross field with |u| = 1 of least ½ ∫ |∇φ|², u = e^{iφ}, aligned on every outer and inner
/// loop and turning d_i times around hole i (METHOD §2; paper, "How to evaluate the choice of a
/// singularity location").
struct UnitNormField
{
  ComplexVector u;       ///< Per edge; exactly unit and exactly aligned.
  double energy = 0.0;   ///< ½ ∫ |∇φ|² = ½ ∫ |∇Φ|² of its conjugate potential.
  /// Largest |u − e^{4iτ}| over the aligned edges before they were set: what rounding and the
  /// linear solver left of the boundary condition.
  double residual = 0.0;
  /// Per inner loop, in (−π, π]: the phase that the single-valued potential carries to it minus the
  /// phase of its alignment. Where it is not zero a harmonic field with a period was added.
  std::vector<double> holonomyDefect;
};

/// Computed from the conjugate potential Φ: sources 4 × the smallest rotation of the cross at every
/// boundary vertex, −2πd_i on hole i, where Φ is one unknown constant, and one period per inner loop
/// so that the phase fits its alignment. How often the phase turns on the way to an inner loop is an
/// integer to choose: the nearest to the single-valued potential, then improved one loop at a time
/// while that lowers the energy.
UnitNormField SolveUnitNorm(const PerforatedProblem& problem);
}
