#pragma once

#include "OptimizerObjective.h"
#include "Progress.h"

#include <functional>
#include <vector>

namespace crossfield
{
/// One configuration on the way.
struct OptimizerStep
{
  double energy = 0.0;    ///< W.
  double objective = 0.0; ///< W, or W + μ J, single-valued, without the barrier.
  double gradientNorm =
    0.0; ///< Of the Lagrangian, times the diagonal of the domain; largest entry.
  double holonomyDefect = 0.0; ///< Largest.
  double stepLength = 0.0;     ///< Longest way that a singularity went to here.
};

/// Why an iteration on one mesh ended.
enum class OptimizerEnd
{
  Rest,   ///< All derivatives are below the tolerance, or steps gain nothing any more.
  Mesh,   ///< A singularity came nearer to the boundary than the mesh resolves.
  Change, ///< The caller's wish; see OptimizerIteration::changes.
  Limit,  ///< The iterations are used up.
  Stuck,  ///< No step lowers the merit.
  Aborted
};

/// Sequential quadratic programming on W with the holonomy defects as equality constraints
/// (docs/method.md §5.5). What it has learnt about the curvature outlives a mesh.
struct OptimizerIteration
{
  double tolerance = 1e-6;
  int maximumIterations = 200;
  int iterations = 0;                 ///< In all.
  std::vector<OptimizerStep> history; ///< From the start on.
  /// The defects that no singularity can change, largest entry.
  double unreachableDefect = 0.0;

  /// Asked after every step; an iteration ends when it says true.
  std::function<bool(const OptimizerPlace&)> changes;
  /// Whether to end with OptimizerEnd::Mesh.
  bool watchesMesh = true;

  /// Moves `here` to where the iteration ends.
  OptimizerEnd Run(
    const OptimizerObjective& objective, const Progress& progress, OptimizerPlace& here);

  /// Forgets the curvature, when the singularities are other ones.
  void Restart() { this->Hessian.resize(0, 0); }

private:
  /// Of the Lagrangian without the positive part of the barrier: where that holds two against W the
  /// curvature of both along their circle cancels.
  Eigen::MatrixXd Hessian;
  double Moved = 0.0;
};
}
