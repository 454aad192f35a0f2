#pragma once

#include "HolomorphicStrains.h"
#include "Progress.h"

namespace crossfield
{
/// Returns the least maximum of |μ| for which strains μ turn the loops by the given angles, to first
/// order (docs/method.md §12.5):
///   max over c of c · r / ∫ |Σ_j c_j Q_j / A| dA.
/// `coefficients` receives the maximiser.
double LeastStrain(
  const DifferentialSample& sample, const Eigen::VectorXd& angles, Eigen::VectorXd& coefficients);

/// Chooses the quarter turns of all inner loops together: whole numbers n for which the least strain
/// that turns the loops by r − n π/2 is small, a closest vector problem. Starts with n = 0 and
/// changes one or two of them by ±1 while the strain falls. Of many loops, only those with the largest
/// defects are changed, each once, so that the work is bounded. Many loops take seconds: `progress` may
/// request an abort at each change, and always receives 0.
Eigen::VectorXi ChooseQuarterTurns(
  const DifferentialSample& sample, const Eigen::VectorXd& defects, const Progress& progress = {});
}
