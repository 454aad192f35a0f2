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
}
}
