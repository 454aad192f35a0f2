#include "ConstrainedMinimiser.h"
#include "LocalSolve.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
ComplexVector RandomVector(Random& random, Eigen::Index size)
{
  ComplexVector x(size);
  for (Complex& value : x)
  {
    value = random.Square();
  }
  return x;
}

DegreeConstraint Cycle(int first, int count, int degree)
{
  DegreeConstraint constraint;
  for (int j = 0; j < count; ++j)
  {
    constraint.unknowns.push_back(first + j);
  }
  constraint.degree = degree;
  constraint.target = count * std::sin(2.0 * Pi * degree / count);
  return constraint;
}
}

TEST(QuadraticConstraint, ValuesAndDerivativesMatchTheDegrees)
{
  Random random(411);
  const std::vector<DegreeConstraint> degrees = { Cycle(0, 7, 1), Cycle(7, 12, -2) };
  const QuadraticConstraint sum = SumOfDegrees(degrees);
  EXPECT_NEAR(sum.target, degrees[0].target + degrees[1].target, 1e-14);
  EXPECT_EQ(sum.size, 19.0);
  for (int trial = 0; trial < 10; ++trial)
  {
    const ComplexVector x = RandomVector(random, 19);
    EXPECT_NEAR(sum.Value(x), degrees[0].Value(x) + degrees[1].Value(x), 1e-13);
    for (const QuadraticConstraint& constraint : { sum, UnitNorm(3) })
    {
      // Central differences of quadratic functions are exact.
      const ComplexVector direction = RandomVector(random, 19);
      const double difference =
        0.5 * (constraint.Value(x + direction) - constraint.Value(x - direction));
      double slope = 0.0;
      const Eigen::VectorXd gradient = constraint.Gradient(x);
      for (Eigen::Index i = 0; i < 19; ++i)
      {
        slope += gradient[2 * i] * direction[i].real() + gradient[2 * i + 1] * direction[i].imag();
      }
      EXPECT_NEAR(slope, difference, 1e-12);
    }
    EXPECT_NEAR(UnitNorm(3).Value(x), std::norm(x[3]), 1e-14);
  }
}

TEST(ConstrainedMinimiser, FindsNearestPointsOfCircles)
{
  // Problem ½ |x − c|² with |x_i| = 1: x = c / |c|, multipliers (|c_i| − 1) / 2.
  Random random(412);
  for (int trial = 0; trial < 20; ++trial)
  {
    QuadraticProblem problem;
    problem.matrix = Eigen::MatrixXcd::Identity(4, 4);
    problem.load = RandomVector(random, 4);
    for (int i = 0; i < 4; ++i)
    {
      problem.load[i] += std::polar(1.5, std::arg(problem.load[i]));
      problem.constraints.push_back(UnitNorm(i));
    }
    const MinimiserResult result = SolveQuadratic(problem, RandomVector(random, 4));
    EXPECT_TRUE(result.converged);
    EXPECT_LT(result.residual, 1e-10);
    for (int i = 0; i < 4; ++i)
    {
      const double size = std::abs(problem.load[i]);
      EXPECT_LT(std::abs(result.x[i] - problem.load[i] / size), 1e-9);
      EXPECT_NEAR(result.multipliers[i], 0.5 * (size - 1.0), 1e-8);
    }
  }
}

TEST(ConstrainedMinimiser, DoesNotReportAMaximumAsConverged)
{
  // At x = −c/|c| all conditions of a solution except the inertia are satisfied.
  QuadraticProblem problem;
  problem.matrix = Eigen::MatrixXcd::Identity(1, 1);
  problem.load = ComplexVector::Constant(1, Complex(0.6, 0.8) * 3.0);
  problem.constraints = { UnitNorm(0) };
  const MinimiserResult result =
    SolveQuadratic(problem, ComplexVector::Constant(1, -Complex(0.6, 0.8)));
  EXPECT_LT(result.residual, 1e-10);
  EXPECT_FALSE(result.converged);
}

TEST(ConstrainedMinimiser, SolvesTheLinearSystemWithoutConstraints)
{
  Random random(413);
  QuadraticProblem problem;
  const Eigen::MatrixXcd root =
    Eigen::MatrixXcd::NullaryExpr(6, 6, [&] { return random.Square(); });
  problem.matrix = root * root.adjoint() + Eigen::MatrixXcd::Identity(6, 6);
  problem.load = RandomVector(random, 6);
  const MinimiserResult result = SolveQuadratic(problem, ComplexVector::Zero(6));
  EXPECT_TRUE(result.converged);
  EXPECT_LT((problem.matrix * result.x - problem.load).norm(), 1e-9);
}
}
