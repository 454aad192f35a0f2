#include "DualSolve.h"

#include "DualMaximum.h"
#include "HoleBases.h"
#include "SerialBlas.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
// Couplings between holes that are left out of a factor, as a part of the mean of the diagonal of S. A step costs the
// cube of the number of those that are kept, which grows with the logarithm of these.
constexpr double Strong = 1e-4;
constexpr double Weak = 1e-8;
constexpr double Rounding = 1e-13;

/// A path by the strong couplings that ends on the border with a residual above this ends there with all of them.
constexpr double WhatWeakOnesChange = 1e-2;
}

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

  // 1. With the strong couplings between holes only, where a step costs next to nothing.
  MinimiserOptions rough = options;
  rough.tolerance = std::max(options.tolerance, 1e-6); // what the others change is larger
  const HoleBases bases(problem);
  DualProblem dual = bases.InBlocks(Strong);
  DualPoint point = MaximiseFromZero(dual, rough, progress.Part(0.0, 0.3), solution.iterations);
  const bool nowhere = point.onBorder && point.residual > WhatWeakOnesChange;

  // 2. With all of them from there; the whole way if that was not close enough. The factor lacks some; where
  // refinement does not make up for that, or they decide whether H is positive definite, once more.
  for (const double leftOut : { Weak, Rounding })
  {
    dual = bases.InBlocks(leftOut);
    dual.refinedWith = &problem;
    point = EvaluateDual(dual, std::move(point.multipliers));
    if (nowhere)
    {
      break;
    }
    point =
      MaximiseNearby(dual, std::move(point), options, progress.Part(0.3, 0.5), solution.iterations);
    if (point.residual > options.tolerance && solution.iterations < options.maximumIterations)
    {
      point = MaximiseFromZero(dual, options, progress.Part(0.5, 1.0), solution.iterations);
    }
    solution.converged = point.residual <= options.tolerance && IsCertain(dual, point);
    if (solution.converged || point.onBorder || solution.iterations >= options.maximumIterations)
    {
      break;
    }
  }
  if (!point.positiveDefinite)
  {
    point = EvaluateDual(dual, Eigen::VectorXd::Zero(dual.targets.size())); // the harmonic field
  }

  solution.x = dual.InValues(point.x);
  solution.multipliers = point.multipliers;
  solution.residual = point.residual;
  return solution;
}
}
