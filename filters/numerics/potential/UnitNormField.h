#pragma once

#include "Alignment.h"

namespace crossfield
{
/// The cross field with |u| = 1 and minimum ½ ∫ |∇φ|², u = e^{iφ}, aligned on every outer and inner
/// loop and turning d_i times around hole i (docs/method.md §2.5; paper, "How to evaluate the
/// choice of a singularity location").
struct UnitNormField
{
  ComplexVector u;     ///< Per edge; exactly of unit norm and exactly aligned.
  double energy = 0.0; ///< ½ ∫ |∇φ|² = ½ ∫ |∇Φ|² of its conjugate potential.
  /// Largest |u − e^{4iτ}| over the aligned edges before they were set exactly: the error of the
  /// boundary condition by rounding and by the linear solver.
  double residual = 0.0;
  /// Per inner loop, in (−π, π]: the phase that the single-valued potential carries to it minus the
  /// phase of its alignment. If it is not zero, a harmonic field with a period was added.
  std::vector<double> holonomyDefect;
  Eigen::VectorXd potential; ///< Φ at the vertices, then its periods around inner loops.
};

/// Computes the field from the conjugate potential Φ of SolveAligned, with a phase that is constant
/// along every boundary edge.
UnitNormField SolveUnitNorm(const PotentialProblem& problem);
}
