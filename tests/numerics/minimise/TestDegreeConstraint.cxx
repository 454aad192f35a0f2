#include "DegreeConstraint.h"
#include "Support.h"

#include <cmath>
#include <numeric>

namespace crossfield::test
{
namespace
{
/// Returns the constraint of a hole of m edges at random positions of a longer vector.
DegreeConstraint RandomConstraint(Random& random, int m, int size)
{
  std::vector<int> places(static_cast<std::size_t>(size));
  std::iota(places.begin(), places.end(), 0);
  random.Shuffle(places);
  DegreeConstraint constraint;
  constraint.unknowns.assign(places.begin(), places.begin() + m);
  return constraint;
}

ComplexVector RandomVector(Random& random, int size)
{
  return ComplexVector::NullaryExpr(size, [&] { return random.Square(); });
}

TEST(DegreeConstraint, ValueIsThePaperSumOverAllEdges)
{
  Random random(20);
  for (int m = 3; m < 40; ++m)
  {
    const DegreeConstraint constraint = RandomConstraint(random, m, m + 9);
    const ComplexVector u = RandomVector(random, m + 9);
    double sum = 0.0;
    for (int j = 0; j < m; ++j)
    {
      const Complex here = u[constraint.unknowns[j]];
      const Complex next = u[constraint.unknowns[(j + 1) % m]];
      const Complex before = u[constraint.unknowns[(j + m - 1) % m]];
      sum += 0.5 * std::imag(std::conj(here) * (next - before));
    }
    EXPECT_NEAR(constraint.Value(u), sum, 1e-13 * m);
  }
}

TEST(DegreeConstraint, ValueGradientAndHessianAreOneQuadraticForm)
{
  Random random(21);
  for (int m = 3; m < 30; ++m)
  {
    const int size = m + 5;
    const DegreeConstraint constraint = RandomConstraint(random, m, size);
    const Eigen::MatrixXcd hessian = constraint.Hessian(size);
    EXPECT_EQ((hessian - hessian.adjoint()).norm(), 0.0);
    const ComplexVector u = RandomVector(random, size);
    const ComplexVector v = RandomVector(random, size);
    EXPECT_NEAR(constraint.Value(u), 0.5 * u.dot(hessian * u).real(), 1e-13 * m);
    EXPECT_LT((constraint.Gradient(u) - hessian * u).norm(), 1e-13 * m);
    // Exact, since C is quadratic: C(u + v) = C(u) + Re⟨v, A u⟩ + C(v).
    EXPECT_NEAR(constraint.Value(u + v),
      constraint.Value(u) + v.dot(constraint.Gradient(u)).real() + constraint.Value(v), 1e-12 * m);
  }
}

TEST(DegreeConstraint, GradientIsTheLimitOfDifferences)
{
  Random random(22);
  const DegreeConstraint constraint = RandomConstraint(random, 17, 25);
  const ComplexVector u = RandomVector(random, 25);
  const ComplexVector gradient = constraint.Gradient(u);
  constexpr double Step = 1e-5;
  for (int i = 0; i < 25; ++i)
  {
    for (const Complex& unit : { Complex(1.0, 0.0), Complex(0.0, 1.0) })
    {
      ComplexVector step = ComplexVector::Zero(25);
      step[i] = Step * unit;
      const double difference =
        (constraint.Value(u + step) - constraint.Value(u - step)) / (2.0 * Step);
      // Central differences of a quadratic are exact up to rounding divided by the step.
      EXPECT_NEAR(difference, (std::conj(unit) * gradient[i]).real(), 1e-9);
    }
  }
}

TEST(DegreeConstraint, IsInvariantUnderRotationOfAllValues)
{
  Random random(23);
  const DegreeConstraint constraint = RandomConstraint(random, 11, 11);
  const ComplexVector u = RandomVector(random, 11);
  EXPECT_NEAR(constraint.Value(random.UnitComplex() * u), constraint.Value(u), 1e-13);
  // Reflected values turn in the opposite direction.
  EXPECT_NEAR(constraint.Value(u.conjugate()), -constraint.Value(u), 1e-13);
}

TEST(DegreeTarget, HasAClosedFormOnRegularPolygons)
{
  Random random(24);
  for (const int m : { 3, 4, 5, 8, 17, 32, 100 })
  {
    const Point centre(random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0));
    const Loop midpoints = RegularPolygon(m, random.Uniform(0.1, 2.0), centre);
    for (int degree = -((m - 1) / 2); 2 * degree < m; ++degree)
    {
      EXPECT_NEAR(
        DegreeTarget(midpoints, centre, degree), m * std::sin(2.0 * Pi * degree / m), 1e-11 * m);
    }
  }
}

TEST(DegreeTarget, EqualsTheValueOfEvenlyTurningUnitVectors)
{
  Random random(25);
  for (int trial = 0; trial < 50; ++trial)
  {
    // A star-shaped hole with edges of arbitrary lengths, seen from a point inside.
    const int m = random.Integer(9, 40);
    const int degree = random.Integer(-4, 4);
    const Point centre(random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0));
    Loop midpoints;
    ComplexVector u(m);
    DegreeConstraint constraint;
    for (int j = 0; j < m; ++j)
    {
      const double angle = 2.0 * Pi * (j + random.Uniform(0.0, 0.9)) / m;
      midpoints.push_back(
        centre + random.Uniform(0.5, 2.0) * Point(std::cos(angle), std::sin(angle)));
      u[j] = std::polar(1.0, degree * angle);
      constraint.unknowns.push_back(j);
    }
    EXPECT_NEAR(DegreeTarget(midpoints, centre, degree), constraint.Value(u), 1e-12);
  }
}

TEST(DegreeTarget, RejectsDegreesTooLargeForTheEdges)
{
  for (int m = 3; m < 20; ++m)
  {
    const Loop midpoints = RegularPolygon(m);
    for (int degree = -12; degree <= 12; ++degree)
    {
      const auto call = [&] { DegreeTarget(midpoints, Point::Zero(), degree); };
      if (2 * std::abs(degree) < m)
      {
        EXPECT_NO_THROW(call());
      }
      else
      {
        // The message states the smallest number of edges that works.
        EXPECT_TRUE(Refuses(call,
          { std::to_string(m) + " edges", "quarter index " + std::to_string(degree),
            "at least " + std::to_string(2 * std::abs(degree) + 1) + " edges" }));
      }
    }
  }
}
}
}
