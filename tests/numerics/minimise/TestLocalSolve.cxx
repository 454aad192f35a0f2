#include "DirectPerforatedSolve.h"
#include "DualSolve.h"
#include "LocalSolve.h"
#include "RandomProblem.h"
#include "Support.h"

#include <Eigen/Cholesky>

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Makes x feasible hole by hole; scaling achieves this where C has the sign of its target.
bool Restore(const ReducedProblem& problem, ComplexVector& x)
{
  for (const DegreeConstraint& constraint : problem.constraints)
  {
    const double ratio = constraint.target / constraint.Value(x);
    if (!(ratio > 0.0))
    {
      return false;
    }
    for (int unknown : constraint.unknowns)
    {
      x[unknown] *= std::sqrt(ratio);
    }
  }
  return true;
}

TEST(LocalSolve, FindsAConstrainedMinimumNearTheStart)
{
  Random random(130);
  int converged = 0;
  for (int trial = 0; trial < 40; ++trial)
  {
    SCOPED_TRACE(trial);
    const ReducedProblem problem = RandomProblem(random, 1 + trial % 4, 0.8);
    ComplexVector start = problem.matrix.Dense().llt().solve(problem.load);
    for (Complex& value : start)
    {
      value += 0.5 * random.Square();
    }
    const MinimiserResult solution = SolveReducedFrom(HoleBases(problem), start);
    if (!solution.converged)
    {
      continue;
    }
    ++converged;
    const ComplexVector gradient =
      problem.matrix * solution.x - problem.load - ConstraintGradients(problem, solution);
    EXPECT_LE(gradient.norm(), 1e-8 * problem.load.norm());
    for (const DegreeConstraint& constraint : problem.constraints)
    {
      EXPECT_NEAR(constraint.Value(solution.x), constraint.target, 1e-8);
    }
    const double best = Objective(problem, solution.x);
    for (int attempt = 0; attempt < 200; ++attempt)
    {
      ComplexVector x = solution.x;
      for (Complex& value : x)
      {
        value += 1e-3 * random.Square();
      }
      ASSERT_TRUE(Restore(problem, x));
      EXPECT_GE(Objective(problem, x), best - 1e-9 * std::abs(best));
    }
  }
  EXPECT_GE(converged, 38);
}

TEST(LocalSolve, KeepsTheGlobalMinimumAndNeverGoesBelowIt)
{
  Random random(131);
  for (int trial = 0; trial < 20; ++trial)
  {
    SCOPED_TRACE(trial);
    const ReducedProblem problem = RandomProblem(random, 1 + trial % 4, 0.4);
    const MinimiserResult global = SolveReduced(HoleBases(problem));
    ASSERT_TRUE(global.converged);
    const MinimiserResult stayed = SolveReducedFrom(HoleBases(problem), global.x);
    ASSERT_TRUE(stayed.converged);
    EXPECT_LE((stayed.x - global.x).norm(), 1e-6 * global.x.norm());
    const ComplexVector elsewhere =
      global.x.unaryExpr([&](const Complex&) { return random.Square(); });
    const MinimiserResult local = SolveReducedFrom(HoleBases(problem), elsewhere);
    if (local.converged)
    {
      const double best = Objective(problem, global.x);
      EXPECT_GE(Objective(problem, local.x), best - 1e-9 * std::abs(best));
    }
  }
}

TEST(LocalSolve, StopsOnAbort)
{
  Random random(132);
  const ReducedProblem problem = RandomProblem(random, 2, 0.5);
  const ComplexVector start = ComplexVector::Ones(problem.load.size());
  EXPECT_THROW(
    SolveReducedFrom(HoleBases(problem), start, {}, Progress([](double) { return false; })),
    Aborted);
}
}
}
