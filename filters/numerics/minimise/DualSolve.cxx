#include "DualSolve.h"

#include "DualMaximum.h"
#include "SerialBlas.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
// Relative size of couplings between holes that are left out of a factor, after HoleBases::Strong.
// A step costs the cube of the number of couplings kept, which grows with the logarithm of these
// tolerances.
constexpr double Weak = 1e-8;
constexpr double Rounding = 1e-13;

/// Members of every hole used on the path when there are many holes: those that turn once around
/// the hole in either direction, to which other holes are coupled most.
constexpr Eigen::Index MembersOnPath = 2;

/// Residual above which a path with the strong couplings that ends on the border is taken to end
/// there with all couplings. A hole of 32 edges that does not turn has 0.2.
constexpr double ResidualWithoutWeakCouplings = 1e-2;
/// The same residual for a path with only some of the strong couplings.
constexpr double ResidualWithoutStrongCouplings = 1e-1;
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

  // 1. Follow the path with the strong couplings between holes only, where a step is cheap.
  MinimiserOptions rough = options;
  // the remaining couplings change more than this
  rough.tolerance = std::max(options.tolerance, 1e-6);
  DualProblem dual = bases.InFewBlocks(MembersOnPath);
  const Eigen::Index membersOnPath = dual.matrix.coupling.rows();
  DualPoint point = MaximiseFromZero(dual, rough, progress.Part(0.0, 0.3), solution.iterations);
  const bool pathIsPartial = membersOnPath < bases.CoupledMembers(HoleBases::Strong);
  const bool noSolution = point.onBorder &&
    point.residual >
      (pathIsPartial ? ResidualWithoutStrongCouplings : ResidualWithoutWeakCouplings);

  // 2. Continue from there with all couplings: x(λ) is refined until its residual includes all of
  // them. The factor still lacks some. Where refinement does not compensate for that, or the
  // missing couplings decide whether H is positive definite, repeat with fewer couplings left out;
  // follow the complete path again if the previous one did not end close enough.
  for (const double leftOut : { HoleBases::Strong, Weak, Rounding })
  {
    if (!noSolution)
    {
      dual = bases.InBlocks(leftOut);
    }
    dual.refinedWith = &problem;
    point = EvaluateDual(dual, std::move(point.multipliers));
    if (noSolution)
    {
      break;
    }
    point =
      MaximiseNearby(dual, std::move(point), options, progress.Part(0.3, 0.5), solution.iterations);
    const bool pathWasTruncated = pathIsPartial || leftOut < HoleBases::Strong;
    if (pathWasTruncated && point.residual > options.tolerance &&
      solution.iterations < options.maximumIterations)
    {
      point = MaximiseFromZero(dual, options, progress.Part(0.5, 1.0), solution.iterations);
    }
    solution.converged = point.residual <= options.tolerance && IsCertain(dual, point);
    if (solution.converged || (point.onBorder && pathWasTruncated) ||
      solution.iterations >= options.maximumIterations)
    {
      break;
    }
  }
  if (noSolution || !point.positiveDefinite)
  {
    // Beyond the border x(λ) is arbitrary: return the harmonic field instead.
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
