#include "DualSolve.h"

#include "DualMaximum.h"
#include "SerialBlas.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
MinimiserResult SolveReduced(
  const ReducedProblem& problem, const MinimiserOptions& options, const Progress& progress)
{
  MinimiserResult solution;
  if (problem.constraints.empty())
  {
    solution.converged = true;
    return solution;
  }
  const SerialBlas serial; // once, not for every small factorisation

  // 1. In the few modes that carry most of the field, where a step costs next to nothing.
  constexpr int LowModes = 4;
  MinimiserOptions rough = options;
  rough.tolerance = std::max(options.tolerance, 1e-6); // what the missing modes change is larger
  const DualPoint low = MaximiseFromZero(
    InModes(problem, LowModes), rough, progress.Part(0.0, 0.3), solution.iterations);

  // 2. In all values from there; the whole way if that was not close enough. Not where the low modes end
  // on the border with a violation that the missing modes cannot take away: on 200 random hard cases they
  // changed the residual by up to 6e-3, and what was left on the border was 2e-2 and more, there and in
  // all values.
  constexpr double MissingModes = 1e-2;
  const DualProblem full = InValues(problem);
  DualPoint point = EvaluateDual(full, low.multipliers);
  const bool nowhere = low.onBorder && low.residual > MissingModes;
  if (!nowhere)
  {
    point =
      MaximiseNearby(full, std::move(point), options, progress.Part(0.3, 0.5), solution.iterations);
    if (point.residual > options.tolerance && solution.iterations < options.maximumIterations)
    {
      point = MaximiseFromZero(full, options, progress.Part(0.5, 1.0), solution.iterations);
    }
  }
  if (!point.positiveDefinite)
  {
    point = EvaluateDual(full, Eigen::VectorXd::Zero(full.targets.size())); // the harmonic field
  }

  solution.x = point.x;
  solution.multipliers = point.multipliers;
  solution.residual = point.residual;
  solution.converged = point.residual <= options.tolerance;
  return solution;
}
}
