// The least strain that turns loops, and the quarter turns chosen by it.

#include "QuarterTurns.h"

#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns random differentials. Each is the one before times `alike` plus a random part.
DifferentialSample RandomSample(Random& random, Eigen::Index loops, double alike)
{
  constexpr Eigen::Index Count = 200;
  DifferentialSample sample{ Eigen::MatrixXcd(Count, loops), Eigen::VectorXd(Count) };
  for (Eigen::Index t = 0; t < Count; ++t)
  {
    sample.areas[t] = random.Uniform(0.5, 1.5);
    for (Eigen::Index j = 0; j < loops; ++j)
    {
      sample.quadratic(t, j) = random.Square();
      if (j > 0)
      {
        sample.quadratic(t, j) += alike * sample.quadratic(t, j - 1);
      }
    }
  }
  return sample;
}

Eigen::VectorXd RandomAngles(Random& random, Eigen::Index count, double largest)
{
  return Eigen::VectorXd::NullaryExpr(count, [&] { return random.Uniform(-largest, largest); });
}

double StrainOf(const DifferentialSample& sample, const Eigen::VectorXd& angles)
{
  Eigen::VectorXd coefficients;
  return LeastStrain(sample, angles, coefficients);
}

/// Returns c · r / ∫ |Σ_j c_j q_j| dA.
double Ratio(
  const DifferentialSample& sample, const Eigen::VectorXd& angles, const Eigen::VectorXd& c)
{
  return c.dot(angles) / (sample.quadratic * c).cwiseAbs().dot(sample.areas);
}

TEST(LeastStrain, IsHomogeneous)
{
  Random random(61);
  for (const Eigen::Index loops : { 1, 2, 5 })
  {
    const DifferentialSample sample = RandomSample(random, loops, 0.5);
    const Eigen::VectorXd angles = RandomAngles(random, loops, 1.0);
    const double strain = StrainOf(sample, angles);
    EXPECT_GT(strain, 0.0);
    for (const double factor : { -1.0, 1e-6, 0.3, 50.0 })
    {
      EXPECT_NEAR(StrainOf(sample, factor * angles), std::abs(factor) * strain,
        1e-12 * std::abs(factor) * strain);
    }
  }
}

TEST(LeastStrain, IsTheMaximumOverCoefficients)
{
  Random random(62);
  for (const Eigen::Index loops : { 1, 2, 5 })
  {
    const DifferentialSample sample = RandomSample(random, loops, 0.5);
    const Eigen::VectorXd angles = RandomAngles(random, loops, 1.0);
    Eigen::VectorXd coefficients;
    const double strain = LeastStrain(sample, angles, coefficients);
    EXPECT_NEAR(Ratio(sample, angles, coefficients), strain, 1e-4 * strain);
    // It is concave, so no direction from the maximiser leads higher.
    for (int i = 0; i < 200; ++i)
    {
      const Eigen::VectorXd away = RandomAngles(random, loops, 1.0) * coefficients.norm();
      for (const double step : { 0.01, 0.1, 1.0 })
      {
        EXPECT_LE(Ratio(sample, angles, coefficients + step * away), 1.0001 * strain);
      }
    }
  }
  // One loop: |r| / ∫ |q|.
  const DifferentialSample one = RandomSample(random, 1, 0.0);
  EXPECT_NEAR(StrainOf(one, Eigen::VectorXd::Constant(1, -0.4)),
    0.4 / one.quadratic.col(0).cwiseAbs().dot(one.areas), 1e-14);
}

TEST(ChooseQuarterTurns, TurnsOneLoopToTheNearestQuarter)
{
  Random random(63);
  const DifferentialSample sample = RandomSample(random, 1, 0.0);
  for (const double defect : { -3.0, -1.2, -0.85, -0.7, 0.0, 0.3, 0.75, 0.85, 1.5, 2.3, 2.5 })
  {
    const Eigen::VectorXi turns = ChooseQuarterTurns(sample, Eigen::VectorXd::Constant(1, defect));
    EXPECT_EQ(turns[0], std::lround(defect / (0.5 * Pi))) << defect;
  }
}

TEST(ChooseQuarterTurns, AreNoWorseThanNone)
{
  Random random(64);
  int changed = 0;
  for (int i = 0; i < 40; ++i)
  {
    const Eigen::Index loops = random.Integer(1, 6);
    const DifferentialSample sample = RandomSample(random, loops, random.Uniform(-2.0, 2.0));
    const Eigen::VectorXd defects = RandomAngles(random, loops, 0.25 * Pi);
    const Eigen::VectorXi turns = ChooseQuarterTurns(sample, defects);
    changed += turns.isZero() ? 0 : 1;
    EXPECT_LE(StrainOf(sample, defects - 0.5 * Pi * turns.cast<double>()),
      1.001 * StrainOf(sample, defects));
  }
  EXPECT_GT(changed, 0);
}

/// Differentials that almost cancel: only loops that turn against each other are turned easily, so
/// the nearest quarters, no turn at all, are not the best.
TEST(ChooseQuarterTurns, ChoosesLoopsTogether)
{
  Random random(65);
  DifferentialSample sample = RandomSample(random, 2, 0.0);
  sample.quadratic.col(1) = -sample.quadratic.col(0) + 0.2 * sample.quadratic.col(1);
  const Eigen::VectorXd defects = Eigen::Vector2d(0.7, 0.75);
  const Eigen::VectorXi turns = ChooseQuarterTurns(sample, defects);
  EXPECT_EQ(turns.sum(), 1);
  EXPECT_EQ(turns.cwiseAbs().sum(), 1);
  EXPECT_LT(
    StrainOf(sample, defects - 0.5 * Pi * turns.cast<double>()), 0.5 * StrainOf(sample, defects));
}

TEST(ChooseQuarterTurns, TurnsTheLargestDefectsOfManyLoops)
{
  // All pairs of 80 loops would take minutes.
  Random random(64);
  constexpr Eigen::Index Loops = 80;
  const DifferentialSample sample = RandomSample(random, Loops, 0.0);
  Eigen::VectorXd defects = RandomAngles(random, Loops, 0.05);
  defects[7] += 0.5 * Pi;
  defects[40] -= 0.5 * Pi;
  Eigen::VectorXi expected = Eigen::VectorXi::Zero(Loops);
  expected[7] = 1;
  expected[40] = -1;
  EXPECT_EQ(ChooseQuarterTurns(sample, defects), expected);
}
}
}
