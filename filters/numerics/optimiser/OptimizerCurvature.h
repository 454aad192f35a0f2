#pragma once

#include "OptimizerObjective.h"

#include <optional>

namespace crossfield
{
/// Second derivatives of the Lagrangian without the positive part of the barrier, by differences of the
/// gradients: as many evaluations as there are coordinates. `multipliers`: one per defect.
Eigen::MatrixXd DifferenceHessian(const OptimizerObjective& objective, const OptimizerPlace& here,
  const Eigen::VectorXd& multipliers);

/// A direction that leaves the symmetries which an objective keeps, changes no defect, and along which
/// the Lagrangian falls from a place where its derivatives vanish: the place is a saddle that symmetry alone
/// holds (docs/method.md §5.5). The longest way of a singularity is 1. Nothing at minima.
/// `free`: the same objective without symmetries.
std::optional<Eigen::VectorXd> FindDescent(const OptimizerObjective& objective,
  const OptimizerObjective& free, const Eigen::VectorXd& place);

/// The longest way of a singularity in a step.
double LongestMove(const Eigen::VectorXd& step);
}
