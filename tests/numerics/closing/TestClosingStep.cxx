#include "ClosingStep.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
TEST(ClosingStep, KeepsDefectsAtZeroExactly)
{
  Random random(1);
  for (int i = 0; i < 10; ++i)
  {
    ClosingConditions conditions;
    const auto fill = [&](Eigen::Index rows)
    {
      Eigen::MatrixXd matrix(rows, 12);
      for (Eigen::Index k = 0; k < matrix.size(); ++k)
      {
        matrix(k) = random.Uniform(-1.0, 1.0);
      }
      return matrix;
    };
    conditions.lengths = fill(4);
    conditions.length = 2.0 * Eigen::VectorXd::Ones(4);
    conditions.defects = fill(3);
    conditions.defect = Eigen::Vector3d(0.1, -0.2, 0.05);
    const ClosingStep step = SolveClosing(conditions);
    EXPECT_LT((conditions.defects * step.moves + conditions.defect).norm(), 1e-12);
    EXPECT_TRUE(step.unreachable.empty());
    // Damping leaves little of the lengths.
    EXPECT_LT((conditions.lengths * step.moves + conditions.length).norm(), 0.05);
  }
}

TEST(ClosingStep, AcceptsRowsThatDependOnEachOther)
{
  ClosingConditions conditions;
  conditions.lengths.resize(3, 2);
  conditions.lengths << 1.0, 0.0, 2.0, 0.0, 1.0, 1e-9;
  conditions.length = Eigen::Vector3d(0.5, 1.0, 0.5);
  conditions.defects.resize(0, 2);
  conditions.defect.resize(0);
  const ClosingStep step = SolveClosing(conditions);
  EXPECT_NEAR(step.moves[0], -0.5, 1e-3);
  EXPECT_NEAR(step.moves[1], 0.0, 1e-6);
  EXPECT_TRUE(step.unreachable.empty());
}

TEST(ClosingStep, NamesRowsThatNoMoveReaches)
{
  // The second length depends on a coordinate that the defect fixes.
  ClosingConditions conditions;
  conditions.lengths = Eigen::MatrixXd::Identity(3, 3);
  conditions.lengths(2, 2) = 0.0;
  conditions.length = Eigen::Vector3d(1.0, 1.0, 2.0);
  conditions.defects = Eigen::RowVector3d(0.0, 1.0, 0.0);
  conditions.defect = Eigen::VectorXd::Zero(1);
  const ClosingStep step = SolveClosing(conditions);
  EXPECT_EQ(step.unreachable, (std::vector<Eigen::Index>{ 2, 1 }));
  EXPECT_NEAR(step.moves[0], -1.0, 1e-3);
  EXPECT_NEAR(step.moves[1], 0.0, 1e-12);
}
}
}
