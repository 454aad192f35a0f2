#pragma once

#include "PositionEnergy.h"

namespace crossfield
{
/// Second derivatives of W by the coordinates of the singularities, two per singularity.
struct PositionCurvature
{
  /// Second derivatives of the single-valued W plus those of the holonomy defects times
  /// multipliers.
  Eigen::MatrixXd hessian;
  /// First derivatives of the regular part R, a column per coordinate; rows of PotentialOperator.
  Eigen::MatrixXd regular;
};

/// Computes the second derivatives (docs/method.md §5.9) for singularities as for
/// PositionEnergy::Evaluate. The response of R to moves is that at the vertices, without that at the
/// midpoints of edges, which would cost three times as much: it is smaller by the relative error of
/// P1, at most a few per cent, and everything else is exact. Costs one back-substitution per
/// coordinate.
PositionCurvature Differentiate(const PositionEnergy& energy, const Configuration& configuration,
  const Eigen::VectorXd& multipliers);
}
