#include "HolonomyRepair.h"

#include "DenseSolvers.h"
#include "Error.h"
#include "OptimizerStage.h"
#include "PoincareHopf.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Tolerance of defects, radians of the phase: far below the error of the mesh and far above
/// rounding.
constexpr double DefectTolerance = 1e-9;

std::vector<double> AsVector(const Eigen::VectorXd& values)
{
  return { values.data(), values.data() + values.size() };
}

[[noreturn]] void ThrowIrreparable(const Eigen::VectorXd& defects, const std::string& reason)
{
  Eigen::Index loop = 0;
  defects.cwiseAbs().maxCoeff(&loop);
  throw Error("The grid lines around inner loop " + std::to_string(loop + 1) +
    " do not close up by " + CrossAngle(defects[loop]) + ", " + reason);
}

[[noreturn]] void ThrowUnreachable(const Eigen::VectorXd& defects)
{
  ThrowIrreparable(
    defects, "which no singularity can change; add a pair of quarter indices 1 and -1 inside.");
}

/// Returns the shortest step with J step = change; throws Error if there is none.
Eigen::VectorXd ShortestStep(const OptimizerState& current, const Eigen::VectorXd& change)
{
  if (current.defectGradient.cols() == 0)
  {
    ThrowUnreachable(current.defects);
  }
  const Eigen::VectorXd step = LeastSquares(current.defectGradient, change);
  // Part of the requested change that no singularity can influence, relative to the change.
  constexpr double UnreachableTolerance = 1e-6;
  if ((current.defectGradient * step - change).norm() > UnreachableTolerance * change.norm())
  {
    ThrowUnreachable(current.defects);
  }
  return step;
}

/// Removes the defects by Newton's method with shortest steps, halved until they reduce the defects
/// and keep the clearance. Adds the number of steps to `steps`.
OptimizerState RemoveDefects(
  const OptimizerObjective& objective, OptimizerState current, int& steps)
{
  constexpr int MaximumSteps = 50;
  constexpr double MinimumFraction = 1e-4;
  for (int i = 0; current.defects.lpNorm<Eigen::Infinity>() > DefectTolerance; ++i, ++steps)
  {
    const Eigen::VectorXd step = ShortestStep(current, -current.defects);
    double fraction = objective.LargestFraction(current.positions, step);
    OptimizerState next = current;
    const auto isBetter = [&]
    {
      if (!std::isfinite(objective.EvaluateBarrier(current.positions + fraction * step).energy))
      {
        return false;
      }
      next = objective.Evaluate(current.positions + fraction * step);
      return next.defects.norm() < current.defects.norm();
    };
    while (fraction > MinimumFraction && !isBetter())
    {
      fraction *= 0.5;
    }
    if (i == MaximumSteps || fraction <= MinimumFraction)
    {
      ThrowIrreparable(objective.Evaluate(objective.Start()).defects,
        "and no positions near the given ones where they do were found; choose other positions.");
    }
    current = next;
  }
  return current;
}
}

HolonomyRepair RepairHolonomy(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& corners, double meshSize, const Progress& progress)
{
  HolonomyRepair result;
  result.singularities = configuration;
  if (domain.loops.size() < 2)
  {
    return result;
  }
  TrackedConfiguration tracked;
  tracked.singularities = configuration;
  tracked.origins.assign(configuration.size(), 0);
  StageOptions options;
  options.meshSize = meshSize;
  options.corners = corners;
  options.objective.clearance = CoreRadius(domain);
  const OptimizerStage stage = MakeStage(domain, tracked, options, progress.Part(0.0, 0.7));
  const OptimizerObjective& objective = *stage.objective;
  const Eigen::VectorXd start = objective.Start();
  OptimizerState current = objective.Evaluate(start);
  result.before = AsVector(current.defects);

  current = RemoveDefects(objective, current, result.steps);
  // A sequence of shortest steps is the shortest displacement only up to the curvature of the
  // conditions. The point closest to the start that satisfies the conditions linearised here is
  // closer; this is repeated as long as the displacement decreases.
  constexpr int MaximumCorrections = 10;
  constexpr double MinimumGain = 1e-8; // relative to the diagonal
  // Nothing to improve if no step was needed.
  for (int i = 0; i < MaximumCorrections && result.steps > 0; ++i)
  {
    const Eigen::VectorXd moved = current.positions - start;
    const Eigen::VectorXd nearest =
      ShortestStep(current, current.defectGradient * moved - current.defects) - moved;
    const Eigen::VectorXd positions =
      current.positions + objective.LargestFraction(current.positions, nearest) * nearest;
    if (!std::isfinite(objective.EvaluateBarrier(positions).energy))
    {
      break;
    }
    OptimizerState next = RemoveDefects(objective, objective.Evaluate(positions), result.steps);
    if (!((next.positions - start).norm() < moved.norm() - MinimumGain))
    {
      break;
    }
    current = std::move(next);
  }
  result.singularities = stage.At(current.positions).singularities;
  result.after = AsVector(current.defects);
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    result.largestMove = std::max(
      result.largestMove, (result.singularities[i].position - configuration[i].position).norm());
  }
  progress.Report(1.0);
  return result;
}
}
