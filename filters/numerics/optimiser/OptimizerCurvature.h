#pragma once

#include "OptimizerObjective.h"

#include <optional>

namespace crossfield
{
/// Returns the multipliers with which the gradient of the Lagrangian is smallest.
Eigen::VectorXd EstimateMultipliers(const OptimizerState& current);

/// Returns a direction that breaks the symmetries kept by an objective, changes no defect, and
/// along which the Lagrangian decreases from a stationary point: the point is then a saddle, which
/// the iteration cannot leave while it keeps the symmetries (docs/method.md §5.5). The direction is
/// scaled to a maximum displacement of 1. Returns nothing at minima. `free`: the same objective
/// without symmetries.
std::optional<Eigen::VectorXd> FindDescent(const OptimizerObjective& objective,
  const OptimizerObjective& free, const Eigen::VectorXd& positions);

/// Returns the maximum displacement of any singularity in a step.
double LargestDisplacement(const Eigen::VectorXd& step);
}
