#pragma once

#include "OptimizerObjective.h"
#include "Progress.h"

#include <functional>
#include <vector>

namespace crossfield
{
/// One step of the iteration.
struct OptimizerStep
{
  double energy = 0.0;    ///< W.
  double objective = 0.0; ///< Single-valued W, or W + μ J, without the barrier.
  /// Largest entry of the gradient of the Lagrangian, multiplied by the diagonal of the domain.
  double gradientNorm = 0.0;
  double holonomyDefect = 0.0; ///< Maximum, radians.
  double stepLength = 0.0;     ///< Largest displacement of a singularity in this step.
};

/// Why an iteration on one mesh ended.
enum class OptimizerEnd
{
  Converged, ///< All derivatives are below the tolerance, or steps no longer lower the objective.
  MeshTooCoarse,   ///< A singularity came closer to the boundary than the mesh resolves.
  ChangeRequested, ///< Requested by the caller; see OptimizerIteration::stopsForChange.
  IterationLimit,  ///< The maximum number of iterations was reached.
  BudgetSpent,     ///< The solves of the budget were used up.
  NoDescent,       ///< No step lowers the merit function.
  Aborted
};

/// Sequential quadratic programming on W with the holonomy defects as equality constraints
/// (docs/method.md §5.5). The approximation of the Hessian is kept when the domain is meshed again.
struct OptimizerIteration
{
  double tolerance = 1e-6;
  int maximumIterations = 200;
  int iterations = 0;                 ///< Total number, over all meshes.
  std::vector<OptimizerStep> history; ///< Steps from the start on.
  /// Largest entry of the defects that no singularity can change, radians.
  double unreachableDefect = 0.0;

  /// Called after every step; the iteration ends with OptimizerEnd::ChangeRequested when it returns
  /// true.
  std::function<bool(const OptimizerState&)> stopsForChange;
  /// Whether the iteration may end with OptimizerEnd::MeshTooCoarse.
  bool checksMesh = true;

  /// Iterates from `current`, and stores the last positions there.
  OptimizerEnd Run(
    const OptimizerObjective& objective, const Progress& progress, OptimizerState& current);

  /// Discards the approximation of the Hessian, for other singularities.
  void Restart() { this->Hessian.resize(0, 0); }

private:
  /// Hessian of the Lagrangian without the barrier, updated after every step.
  Eigen::MatrixXd Hessian;
  /// Number of solves of the budget at which the Hessian is computed again.
  std::size_t Renewal = 0;
  double LastDisplacement = 0.0;
};
}
