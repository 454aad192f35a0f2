#include "ClearanceBarrier.h"

#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
TEST(ClearanceBarrier, GradientMatchesDifferences)
{
  const PlanarDomain square = Builtin("square");
  const Configuration two = { { { 0.12, 0.13 }, 1, 0.0 }, { { 0.25, 0.16 }, -2, 0.0 } };
  const ClearanceBarrier barrier(square, two, 0.1);
  Eigen::VectorXd positions(4);
  positions << 0.12, 0.13, 0.25, 0.16;
  const ClearanceBarrier::Value value = barrier.Evaluate(positions);
  ASSERT_TRUE(std::isfinite(value.energy));
  EXPECT_GT(value.energy, 0.0);
  const double step = 1e-6;
  for (Eigen::Index i = 0; i < 4; ++i)
  {
    Eigen::VectorXd moved = positions;
    moved[i] += step;
    const double above = barrier.Evaluate(moved).energy;
    moved[i] -= 2.0 * step;
    EXPECT_NEAR(value.gradient[i], (above - barrier.Evaluate(moved).energy) / (2.0 * step),
      1e-6 * value.gradient.norm());
  }
  positions[0] = 0.09;
  EXPECT_FALSE(std::isfinite(barrier.Evaluate(positions).energy));
  positions << 0.5, 0.5, 0.25, 0.7;
  EXPECT_EQ(barrier.Evaluate(positions).energy, 0.0);
}

/// At an edge with a factor, the barrier is that of a clearance that is larger by the factor.
TEST(ClearanceBarrier, FactorsEnlargeTheClearance)
{
  const PlanarDomain square = Builtin("square");
  const Configuration one = { { { 0.5, 0.03 }, 1, 0.0 } };
  ClearanceFactors factors(1, std::vector<double>(square.loops[0].size(), 2.0));
  const ClearanceBarrier scaled(square, one, 0.01, factors);
  const ClearanceBarrier plain(square, one, 0.02);
  Eigen::VectorXd position(2);
  for (const double height : { 0.021, 0.03, 0.039, 0.05 })
  {
    position << 0.5, square.loops[0][0].y() + height;
    const ClearanceBarrier::Value value = scaled.Evaluate(position);
    EXPECT_EQ(value.energy, plain.Evaluate(position).energy);
    EXPECT_EQ(value.gradient, plain.Evaluate(position).gradient);
    EXPECT_EQ(value.hessian, plain.Evaluate(position).hessian);
  }
}

TEST(ClearanceBarrier, PartsOfEdgesHaveTheirFactors)
{
  PlanarDomain ring = Builtin("square");
  ring.loops.push_back({ { 0.4, 0.4 }, { 0.4, 0.6 }, { 0.6, 0.6 }, { 0.6, 0.4 } });
  PlanarDomain refined = ring;
  Loop& outer = refined.loops[0];
  outer.insert(
    outer.begin() + 2, { 0.25 * outer[1] + 0.75 * outer[2], 0.5 * (outer[1] + outer[2]) });
  outer.push_back(0.5 * (outer.back() + outer.front()));
  refined.loops[1].insert(refined.loops[1].begin() + 1, { 0.4, 0.5 });
  const ClearanceFactors factors = { { 1.0, 2.0, 3.0, 4.0 }, { 5.0, 6.0, 7.0, 8.0 } };
  EXPECT_EQ(FactorsOfParts(ring, ring, factors), factors);
  EXPECT_EQ(FactorsOfParts(ring, refined, factors),
    (ClearanceFactors{ { 1.0, 2.0, 2.0, 2.0, 3.0, 4.0, 4.0 }, { 5.0, 5.0, 6.0, 7.0, 8.0 } }));
  EXPECT_TRUE(FactorsOfParts(ring, refined, {}).empty());
}
}
}
