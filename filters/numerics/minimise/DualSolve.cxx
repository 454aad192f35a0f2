#include "DualSolve.h"

#include "DualMaximum.h"
#include "SerialBlas.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
// Couplings between holes that are left out of a factor, beside HoleBases::Strong. A step costs the cube of the number of
// those that are kept, which grows with the logarithm of these.
constexpr double Weak = 1e-8;
constexpr double Rounding = 1e-13;

/// Members of every hole on the path, where there are many holes: those that turn once around it, either way, which other
/// holes feel most.
constexpr Eigen::Index MembersOnPath = 2;

/// A path by the strong couplings that ends on the border with a residual above this ends there with all of them. A hole of
/// 32 edges that does not turn has 0.2.
constexpr double WhatWeakOnesChange = 1e-2;
/// The same for a path by a part of the strong ones.
constexpr double WhatStrongOnesChange = 1e-1;
}

MinimiserResult SolveReduced(
  const HoleBases& bases, const MinimiserOptions& options, const Progress& progress)
{
  const ReducedProblem& problem = bases.GetProblem();
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
  DualProblem dual = bases.InFewBlocks(MembersOnPath);
  const Eigen::Index membersOnPath = dual.matrix.coupling.rows();
  DualPoint point = MaximiseFromZero(dual, rough, progress.Part(0.0, 0.3), solution.iterations);
  const bool some = membersOnPath < bases.CoupledMembers(HoleBases::Strong);
  const bool nowhere =
    point.onBorder && point.residual > (some ? WhatStrongOnesChange : WhatWeakOnesChange);

  // 2. With all of them from there: x(λ) is refined until nothing is left out of it. The factor lacks some; where
  // refinement does not make up for that, or they decide whether H is positive definite, once more with fewer left out, and
  // then the whole way if that was not close enough.
  for (const double leftOut : { HoleBases::Strong, Weak, Rounding })
  {
    if (!nowhere)
    {
      dual = bases.InBlocks(leftOut);
    }
    dual.refinedWith = &problem;
    point = EvaluateDual(dual, std::move(point.multipliers));
    if (nowhere)
    {
      break;
    }
    point =
      MaximiseNearby(dual, std::move(point), options, progress.Part(0.3, 0.5), solution.iterations);
    const bool wayWasWithFewer = some || leftOut < HoleBases::Strong;
    if (wayWasWithFewer && point.residual > options.tolerance &&
      solution.iterations < options.maximumIterations)
    {
      point = MaximiseFromZero(dual, options, progress.Part(0.5, 1.0), solution.iterations);
    }
    solution.converged = point.residual <= options.tolerance && IsCertain(dual, point);
    if (solution.converged || (point.onBorder && wayWasWithFewer) ||
      solution.iterations >= options.maximumIterations)
    {
      break;
    }
  }
  if (nowhere || !point.positiveDefinite)
  {
    // Past the border x(λ) may be anything: then the harmonic field.
    DualPoint harmonic = EvaluateDual(dual, Eigen::VectorXd::Zero(dual.targets.size()));
    if (!point.positiveDefinite || !(point.residual <= harmonic.residual))
    {
      point = std::move(harmonic);
    }
  }

  solution.x = dual.InValues(point.x);
  solution.multipliers = point.multipliers;
  solution.residual = point.residual;
  return solution;
}
}
