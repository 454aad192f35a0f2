#include "DirectPerforatedSolve.h"
#include "DualSolve.h"
#include "RandomProblem.h"
#include "ReducedProblem.h"
#include "Support.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <cmath>

namespace crossfield::test
{
namespace
{
void ExpectOptimalityConditions(const ReducedProblem& problem, const MinimiserResult& solution)
{
  ComplexVector gradient = problem.matrix * solution.x - problem.load;
  EXPECT_LE((gradient - ConstraintGradients(problem, solution)).norm(), 1e-8 * problem.load.norm());
  for (std::size_t i = 0; i < problem.constraints.size(); ++i)
  {
    const DegreeConstraint& constraint = problem.constraints[i];
    gradient +=
      solution.multipliers[static_cast<Eigen::Index>(i)] * constraint.Gradient(solution.x);
    EXPECT_NEAR(constraint.Value(solution.x), constraint.target, 1e-8);
  }
  EXPECT_LE(gradient.norm(), 1e-8 * problem.load.norm());
}

TEST(ReducedProblem, SolutionSatisfiesTheOptimalityConditions)
{
  Random random(30);
  for (int trial = 0; trial < 30; ++trial)
  {
    SCOPED_TRACE(trial);
    const ReducedProblem problem = RandomProblem(random, 1 + trial % 5, 0.4);
    const MinimiserResult solution = SolveReduced(HoleBases(problem));
    ASSERT_TRUE(solution.converged) << solution.residual;
    EXPECT_GT(solution.iterations, 0);
    ExpectOptimalityConditions(problem, solution);
  }
}

TEST(ReducedProblem, SolvesOneConstraintFromAnyHarmonicField)
{
  // A quadratic problem with one quadratic constraint has no duality gap, whatever the start.
  Random random(31);
  for (int trial = 0; trial < 30; ++trial)
  {
    SCOPED_TRACE(trial);
    ReducedProblem problem = RandomProblem(random, 1, 0.0);
    problem.load = problem.load.unaryExpr([&](const Complex&) { return random.Square(); });
    const MinimiserResult solution = SolveReduced(HoleBases(problem));
    ASSERT_TRUE(solution.converged) << solution.residual;
    ExpectOptimalityConditions(problem, solution);
  }
}

/// Problem with a known solution: S + Σ λ_i A_i is positive definite with smallest eigenvalue
/// `margin`, so x minimises the problem with the b and targets computed from it. With a small
/// component of x along the eigenvector of that eigenvalue, the dual is nearly flat up to the
/// border of its region.
struct KnownProblem
{
  ReducedProblem problem;
  ComplexVector x;
  Eigen::VectorXd multipliers;
};

KnownProblem RandomKnownProblem(Random& random, int holeCount, double margin)
{
  KnownProblem known{ RandomProblem(random, holeCount, 0.0), {}, {} };
  ReducedProblem& problem = known.problem;
  const Eigen::Index size = problem.matrix.Rows();
  known.multipliers = Eigen::VectorXd::NullaryExpr(
    holeCount, [&] { return random.Uniform(0.5, 1.0) * (random.Integer(0, 1) == 0 ? 1 : -1); });
  const auto withMultipliers = [&]
  {
    Eigen::MatrixXcd hessian = problem.matrix.Dense().cast<Complex>();
    for (int i = 0; i < holeCount; ++i)
    {
      hessian += known.multipliers[i] *
        Eigen::MatrixXcd(problem.constraints[static_cast<std::size_t>(i)].Hessian(size));
    }
    return hessian;
  };
  // H(s λ) is S at s = 0 and indefinite for large s.
  const Eigen::MatrixXcd added = withMultipliers() - problem.matrix.Dense().cast<Complex>();
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXcd> spectrum(
    added, problem.matrix.Dense().cast<Complex>(), Eigen::EigenvaluesOnly);
  known.multipliers *= (1.0 - margin) / -spectrum.eigenvalues()[0];
  const Eigen::MatrixXcd hessian = withMultipliers();
  known.x = problem.matrix.Dense().cast<Complex>().llt().solve(problem.load) +
    ComplexVector::NullaryExpr(size, [&] { return 0.3 * random.Square(); });
  problem.load = hessian * known.x;
  for (DegreeConstraint& constraint : problem.constraints)
  {
    constraint.target = constraint.Value(known.x);
  }
  return known;
}

TEST(ReducedProblem, FindsKnownSolutionsNearTheBorder)
{
  Random random(37);
  for (int trial = 0; trial < 60; ++trial)
  {
    const double margin = std::pow(10.0, -1 - trial % 4);
    SCOPED_TRACE(testing::Message() << trial << ", margin " << margin);
    const KnownProblem known = RandomKnownProblem(random, 1 + trial % 7, margin);
    const MinimiserResult solution = SolveReduced(HoleBases(known.problem));
    EXPECT_TRUE(solution.converged) << solution.residual;
    EXPECT_LE(solution.iterations, 60);
    // The error in x that corresponds to an error of 1e-10 in the gradient.
    EXPECT_LE((solution.x - known.x).norm(), 1e-9 / margin * known.x.norm());
    EXPECT_LE((solution.multipliers - known.multipliers).norm(), 1e-8 / margin);
  }
}

TEST(ReducedProblem, NoFeasiblePointIsBetter)
{
  Random random(32);
  for (int trial = 0; trial < 20; ++trial)
  {
    SCOPED_TRACE(trial);
    const ReducedProblem problem = RandomProblem(random, 1 + trial % 4, 0.5);
    const MinimiserResult solution = SolveReduced(HoleBases(problem));
    ASSERT_TRUE(solution.converged);
    const double best = Objective(problem, solution.x);
    int compared = 0;
    for (int attempt = 0; attempt < 400; ++attempt)
    {
      // Distances range from tiny steps to points unrelated to the solution.
      const double distance = std::exp(random.Uniform(std::log(1e-3), std::log(3.0)));
      ComplexVector x = solution.x;
      for (Complex& value : x)
      {
        value += distance * random.Square();
      }
      bool feasible = true;
      for (const DegreeConstraint& constraint : problem.constraints)
      {
        // C is homogeneous of degree two in the values of its own hole.
        const double ratio = constraint.target / constraint.Value(x);
        feasible = feasible && ratio > 0.0;
        for (int unknown : constraint.unknowns)
        {
          x[unknown] *= std::sqrt(std::abs(ratio));
        }
      }
      if (feasible)
      {
        ++compared;
        ASSERT_GE(Objective(problem, x), best - 1e-9 * std::abs(best));
      }
    }
    EXPECT_GT(compared, 100);
  }
}

TEST(ReducedProblem, KeepsAFeasibleHarmonicField)
{
  Random random(33);
  const ReducedProblem problem = RandomProblem(random, 3, 0.0);
  const ComplexVector harmonic = problem.matrix.Dense().llt().solve(problem.load);
  const MinimiserResult held = SolveReduced(HoleBases(problem));
  EXPECT_TRUE(held.converged);
  EXPECT_EQ(held.iterations, 0);
  EXPECT_LE((held.x - harmonic).norm(), 1e-12 * harmonic.norm());
  EXPECT_LE(held.multipliers.norm(), 1e-12);
}

TEST(ReducedProblem, EmptyProblemIsSolved)
{
  EXPECT_TRUE(SolveReduced(HoleBases(ReducedProblem())).converged);
}

TEST(ReducedProblem, IsEquivariantUnderRotationAndScaling)
{
  Random random(34);
  const ReducedProblem problem = RandomProblem(random, 3, 0.4);
  const MinimiserResult solution = SolveReduced(HoleBases(problem));
  ASSERT_TRUE(solution.converged);
  ReducedProblem changed = problem;
  const Complex phase = random.UnitComplex();
  changed.load *= 1e6 * phase;
  changed.matrix = MatrixOn(problem.constraints, 1e6 * problem.matrix.Dense());
  const MinimiserResult moved = SolveReduced(HoleBases(changed));
  ASSERT_TRUE(moved.converged);
  EXPECT_EQ(moved.iterations, solution.iterations);
  EXPECT_LE((moved.x - phase * solution.x).norm(), 1e-9 * solution.x.norm());
  EXPECT_LE(
    (moved.multipliers / 1e6 - solution.multipliers).norm(), 1e-9 * solution.multipliers.norm());
}

TEST(ReducedProblem, ReportsNonConvergence)
{
  Random random(35);
  ReducedProblem problem = RandomProblem(random, 2, 0.5);
  MinimiserOptions hurried;
  hurried.maximumIterations = 1;
  const MinimiserResult early = SolveReduced(HoleBases(problem), hurried);
  EXPECT_FALSE(early.converged);
  EXPECT_EQ(early.iterations, 1);
  EXPECT_GT(early.residual, hurried.tolerance);
  // If the field is zero on the hole, all directions are equivalent.
  problem.load.setZero();
  const MinimiserResult stuck = SolveReduced(HoleBases(problem));
  EXPECT_FALSE(stuck.converged);
  EXPECT_LT(stuck.iterations, 60); // it reports this long before the limit
  EXPECT_TRUE(stuck.x.allFinite());
  EXPECT_TRUE(stuck.multipliers.allFinite());
}

TEST(ReducedProblem, StopsOnAbort)
{
  Random random(36);
  const ReducedProblem problem = RandomProblem(random, 2, 0.5);
  EXPECT_THROW(
    SolveReduced(HoleBases(problem), {}, Progress([](double) { return false; })), Aborted);
}
}
}
