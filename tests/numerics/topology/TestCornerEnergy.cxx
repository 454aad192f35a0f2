#include "CornerEnergy.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
constexpr double Interior = Pi / 16.0;

/// Returns the index in −4 .. 4 of minimum energy at a given price per quarter, by brute force.
int CheapestQuarters(double angle, double price)
{
  int best = -4;
  for (int k = -4; k <= 4; ++k)
  {
    if (CornerEnergy(angle, k) - price * k < CornerEnergy(angle, best) - price * best)
    {
      best = k;
    }
  }
  return best;
}

TEST(CornerEnergy, VanishesIfTheCrossIsAlignedWithBothSides)
{
  EXPECT_EQ(CornerEnergy(Pi, 0), 0.0);
  EXPECT_EQ(CornerEnergy(0.5 * Pi, 1), 0.0);
  EXPECT_EQ(CornerEnergy(1.5 * Pi, -1), 0.0);
  EXPECT_EQ(CornerEnergy(2.0 * Pi, -2), 0.0);
  // A quarter on a flat boundary has the cost given in the paper.
  EXPECT_DOUBLE_EQ(CornerEnergy(Pi, 1), Pi / 8.0);
  EXPECT_DOUBLE_EQ(InteriorQuarterEnergy(InteriorCoefficient::Logarithm), Pi / 16.0);
  EXPECT_DOUBLE_EQ(InteriorQuarterEnergy(InteriorCoefficient::Printed), Pi / 8.0);
}

TEST(CornerEnergy, NextQuarterCostIsTheDifference)
{
  Random random(50);
  for (int trial = 0; trial < 1000; ++trial)
  {
    const double angle = random.Uniform(0.05, 2.0 * Pi);
    const int k = random.Integer(-4, 4);
    const double difference = CornerEnergy(angle, k + 1) - CornerEnergy(angle, k);
    EXPECT_NEAR(
      NextQuarterCost(angle, k), difference, 1e-12 * (1.0 + std::abs(difference)) / angle);
  }
}

TEST(CornerEnergy, RangesOfTheTheorems)
{
  // Thresholds from large to small index; below the first one the index is 2.
  const std::vector<double> scarce = { 2.0 / 7.0, 6.0 / 7.0, 10.0 / 7.0 };
  const std::vector<double> excess = { 2.0 / 9.0, 2.0 / 3.0, 10.0 / 9.0, 14.0 / 9.0 };
  const auto check = [](const std::vector<double>& thresholds, double price)
  {
    for (std::size_t i = 0; i < thresholds.size(); ++i)
    {
      const int above = 1 - static_cast<int>(i);
      EXPECT_EQ(CheapestQuarters(thresholds[i] * Pi - 1e-6, price), above + 1) << thresholds[i];
      EXPECT_EQ(CheapestQuarters(thresholds[i] * Pi + 1e-6, price), above) << thresholds[i];
    }
    EXPECT_EQ(CheapestQuarters(1e-3, price), 2);
    EXPECT_EQ(CheapestQuarters(2.0 * Pi - 1e-3, price), 2 - static_cast<int>(thresholds.size()));
  };
  check(scarce, Interior);
  check(excess, -Interior);
}

TEST(CornerEnergy, BalancedRangesOverlap)
{
  // k is allowed where neither adding nor removing a quarter in exchange for an interior one
  // decreases the energy.
  const auto allowed = [](double angle, int k)
  {
    return CornerEnergy(angle, k + 1) + Interior >= CornerEnergy(angle, k) &&
      CornerEnergy(angle, k - 1) + Interior >= CornerEnergy(angle, k);
  };
  const auto check = [&](int k, double from, double to)
  {
    EXPECT_FALSE(allowed(from * Pi - 1e-6, k)) << k;
    EXPECT_TRUE(allowed(from * Pi + 1e-6, k)) << k;
    EXPECT_TRUE(allowed(to * Pi - 1e-6, k)) << k;
    EXPECT_FALSE(allowed(to * Pi + 1e-6, k)) << k;
  };
  check(0, 2.0 / 3.0, 10.0 / 7.0);
  check(1, 2.0 / 9.0, 6.0 / 7.0);
  // The conventional limit is inside the overlap.
  EXPECT_TRUE(allowed(0.75 * Pi, 0) && allowed(0.75 * Pi, 1));
}
}
}
