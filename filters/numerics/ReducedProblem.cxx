#include "ReducedProblem.h"

#include "DualMaximum.h"
#include "SerialBlas.h"

#include <algorithm>

namespace crossfield
{
ComplexVector ReducedSolution::Forces(const ReducedProblem& problem) const
{
  ComplexVector forces = ComplexVector::Zero(this->x.size());
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    forces -=
      this->multipliers[static_cast<Eigen::Index>(i)] * problem.constraints[i].Gradient(this->x);
  }
  return forces;
}

ReducedSolution SolveReduced(
  const ReducedProblem& problem, const ReducedOptions& options, const Progress& progress)
{
  ReducedSolution solution;
  if (problem.constraints.empty())
  {
    solution.converged = true;
    return solution;
  }
  const SerialBlas serial; // once, not for every small factorisation

  // 1. In the few modes that carry most of the field, where a step costs next to nothing.
  constexpr int LowModes = 4;
  ReducedOptions rough = options;
  rough.tolerance = std::max(options.tolerance, 1e-6); // what the missing modes change is larger
  const DualPoint low = MaximiseFromZero(
    InModes(problem, LowModes), rough, progress.Part(0.0, 0.3), solution.iterations);

  // 2. In all values from there; the whole way if that was not close enough.
  const DualProblem full = InValues(problem);
  DualPoint point = MaximiseNearby(full, EvaluateDual(full, low.multipliers), options,
    progress.Part(0.3, 0.5), solution.iterations);
  const bool more = point.residual > options.tolerance &&
    solution.iterations < options.maximumIterations;
  if (!point.positiveDefinite || more)
  {
    point = MaximiseFromZero(full, options, progress.Part(0.5, 1.0), solution.iterations);
  }

  solution.x = point.x;
  solution.multipliers = point.multipliers;
  solution.residual = point.residual;
  solution.converged = point.residual <= options.tolerance;
  return solution;
}
}
