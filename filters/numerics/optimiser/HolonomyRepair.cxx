#include "HolonomyRepair.h"

#include "Error.h"
#include "OptimizerStage.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Radians of the phase: far below what the mesh is off by, and far above rounding.
constexpr double NoDefect = 1e-9;

std::vector<double> AsVector(const Eigen::VectorXd& values)
{
  return { values.data(), values.data() + values.size() };
}

[[noreturn]] void ThrowStuck(const Eigen::VectorXd& defects)
{
  Eigen::Index loop = 0;
  defects.cwiseAbs().maxCoeff(&loop);
  throw Error("The holonomy defect of inner loop " + std::to_string(loop + 1) + ", " +
    std::to_string(defects[loop]) +
    " radians, cannot be repaired by moving the singularities; add a pair of quarter indices 1 and -1, or "
    "let them be optimised.");
}

/// The shortest step with J step = wanted; throws where there is none.
Eigen::VectorXd ShortestStep(const OptimizerPlace& here, const Eigen::VectorXd& wanted)
{
  if (here.defectGradient.cols() == 0)
  {
    ThrowStuck(here.defects);
  }
  const Eigen::VectorXd step = here.defectGradient.completeOrthogonalDecomposition().solve(wanted);
  // What no singularity has an influence on, relative to what is asked for.
  constexpr double Unreachable = 1e-6;
  if ((here.defectGradient * step - wanted).norm() > Unreachable * wanted.norm())
  {
    ThrowStuck(here.defects);
  }
  return step;
}

/// Newton's method for the defects with shortest steps, halved until they lower the defects and keep the
/// clearance. Adds to `steps`.
OptimizerPlace RemoveDefects(const OptimizerObjective& objective, OptimizerPlace here, int& steps)
{
  constexpr int MostSteps = 50;
  constexpr double LeastPart = 1e-4;
  for (int i = 0; here.defects.lpNorm<Eigen::Infinity>() > NoDefect; ++i, ++steps)
  {
    const Eigen::VectorXd step = ShortestStep(here, -here.defects);
    double part = objective.LongestPart(here.place, step);
    OptimizerPlace next = here;
    const auto isBetter = [&]
    {
      if (!std::isfinite(objective.EvaluateBarrier(here.place + part * step).energy))
      {
        return false;
      }
      next = objective.Evaluate(here.place + part * step);
      return next.defects.norm() < here.defects.norm();
    };
    while (part > LeastPart && !isBetter())
    {
      part *= 0.5;
    }
    if (i == MostSteps || part <= LeastPart)
    {
      ThrowStuck(here.defects);
    }
    here = next;
  }
  return here;
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
  OptimizerPlace here = objective.Evaluate(start);
  result.before = AsVector(here.defects);

  here = RemoveDefects(objective, here, result.steps);
  // The shortest steps are the shortest way but for the curvature of the conditions: the start's nearest point
  // on the conditions linearised here is nearer, as long as it is.
  constexpr int MostCorrections = 10;
  constexpr double Gain = 1e-8; // of the diagonal
  // Where nothing moved there is no way to shorten.
  for (int i = 0; i < MostCorrections && result.steps > 0; ++i)
  {
    const Eigen::VectorXd moved = here.place - start;
    const Eigen::VectorXd nearest =
      ShortestStep(here, here.defectGradient * moved - here.defects) - moved;
    const Eigen::VectorXd place = here.place + objective.LongestPart(here.place, nearest) * nearest;
    if (!std::isfinite(objective.EvaluateBarrier(place).energy))
    {
      break;
    }
    OptimizerPlace next = RemoveDefects(objective, objective.Evaluate(place), result.steps);
    if (!((next.place - start).norm() < moved.norm() - Gain))
    {
      break;
    }
    here = std::move(next);
  }
  result.singularities = stage.At(here.place).singularities;
  result.after = AsVector(here.defects);
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    result.largestMove = std::max(
      result.largestMove, (result.singularities[i].position - configuration[i].position).norm());
  }
  progress.Report(1.0);
  return result;
}
}
