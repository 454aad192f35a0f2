#include "Elimination.h"

#include "Support.h"

#include <Eigen/Dense>

namespace crossfield::test
{
TEST(Elimination, SolvesTheEquationsExactly)
{
  Elimination system({ 0, 0, 0, 0, 0 });
  system.Impose({ { 0, 1.0 }, { 1, -1.0 }, { 2, 1.0 } });
  system.Impose({ { 1, 1.0 }, { 3, 1.0 } });
  system.Impose({ { 0, 1.0 }, { 2, 1.0 }, { 3, 1.0 } }); // follows from the first two
  const Eigen::MatrixXd all = Eigen::MatrixXd(system.Prolongation());
  ASSERT_EQ(all.cols(), 3);
  EXPECT_EQ((all.row(0) - all.row(1) + all.row(2)).norm(), 0.0);
  EXPECT_EQ((all.row(1) + all.row(3)).norm(), 0.0);
}

TEST(Elimination, KeepsTheRankOfRandomSystems)
{
  Random random(5);
  for (int round = 0; round < 50; ++round)
  {
    constexpr int Unknowns = 12;
    Elimination system(std::vector<int>(Unknowns, 0));
    Eigen::MatrixXd imposed = Eigen::MatrixXd::Zero(6, Unknowns);
    for (int e = 0; e < 6; ++e)
    {
      // Sums and differences of two unknowns, as for sides and seams.
      const int a = random.Integer(0, Unknowns - 1);
      const int b = (a + random.Integer(1, Unknowns - 1)) % Unknowns;
      imposed(e, a) = 1.0;
      imposed(e, b) = random.Integer(0, 1) == 0 ? 1.0 : -1.0;
      system.Impose({ { a, 1.0 }, { b, imposed(e, b) } });
    }
    const Eigen::MatrixXd all = Eigen::MatrixXd(system.Prolongation());
    EXPECT_EQ((imposed * all).norm(), 0.0);
    EXPECT_EQ(all.cols(), Unknowns - imposed.fullPivLu().rank());
  }
}

TEST(Elimination, RefusesEquationsWithoutPivot)
{
  Elimination system({ 0, 0 });
  EXPECT_TRUE(Refuses(
    [&] {
      system.Impose({ { 0, 2.0 }, { 1, 3.0 } });
    },
    { "no integral solution" }));
}
}
