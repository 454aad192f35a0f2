// Heights of the rows of a boundary layer: the formulas against sums of their rows.

#include "LayerRows.h"

#include "Support.h"

#include <cmath>
#include <numeric>

namespace crossfield::test
{
namespace
{
TEST(LayerRows, NeededNumberIsTheSmallestThatFillsTheLength)
{
  Random random(311);
  for (int i = 0; i < 200; ++i)
  {
    const double growth = random.Uniform(1.02, 2.0);
    const double first = std::exp(random.Uniform(-12.0, 0.0));
    const double length = first * std::exp(random.Uniform(0.01, 9.0));
    const int rows = RowsToFill(length, first, growth);
    const auto sum = [&](int count)
    {
      double total = 0.0;
      for (int row = 0; row < count; ++row)
      {
        total += first * std::pow(growth, row);
      }
      return total;
    };
    EXPECT_GE(sum(rows), length * (1.0 - 1e-5)) << growth << " " << rows;
    EXPECT_LT(sum(rows - 1), length) << growth << " " << rows;
  }
}

TEST(LayerRows, GrowthFillsTheLength)
{
  Random random(312);
  for (int i = 0; i < 200; ++i)
  {
    const int rows = random.Integer(1, 60);
    const double first = std::exp(random.Uniform(-12.0, 0.0));
    // Also rows that become smaller, N a > S > a.
    const double length = first * std::max(0.3 * rows, 1.01) * std::exp(random.Uniform(0.0, 6.0));
    const double growth = rows == 1 ? 1.0 : GrowthToFill(length, first, rows);
    const std::vector<double> ends = RowEnds(length, first, rows);
    ASSERT_EQ(ends.size(), static_cast<std::size_t>(rows));
    EXPECT_EQ(ends.back(), length);
    if (rows == 1)
    {
      continue;
    }
    EXPECT_NEAR(ends[0], first, 1e-9 * first);
    EXPECT_EQ(growth > 1.0, length > rows * first * (1.0 + 1e-12));
    double height = ends[0];
    for (std::size_t row = 1; row < ends.size(); ++row)
    {
      const double next = ends[row] - ends[row - 1];
      EXPECT_GT(next, 0.0);
      EXPECT_NEAR(next, growth * height, 1e-9 * length) << row;
      height = next;
    }
  }
}

TEST(LayerRows, EqualRowsHaveGrowthOne)
{
  EXPECT_NEAR(GrowthToFill(3.0, 0.5, 6), 1.0, 1e-9);
}

TEST(LayerRows, NeededRowsGrowAtMostAsPrescribed)
{
  Random random(313);
  for (int i = 0; i < 200; ++i)
  {
    const double growth = random.Uniform(1.02, 2.0);
    const double length = std::exp(random.Uniform(0.01, 9.0));
    const int rows = RowsToFill(length, 1.0, growth);
    EXPECT_LE(rows == 1 ? 1.0 : GrowthToFill(length, 1.0, rows), growth * (1.0 + 1e-6));
  }
}

TEST(LayerRows, LastRowMatchesTheReplacedOnes)
{
  EXPECT_EQ(RowsToReplace(1.2), 5);
  EXPECT_EQ(RowsToReplace(1.25), 4);
  EXPECT_EQ(RowsToReplace(1.5), 2);
  EXPECT_EQ(RowsToReplace(1.1), 10);
  EXPECT_EQ(RowsToReplace(3.0), 1);
  // The last of rows from a small height, which fill so many rows of height 1, has the height 1 up to
  // a factor of the growth.
  for (const double growth : { 1.1, 1.2, 1.25, 1.5, 2.0 })
  {
    const int replaced = RowsToReplace(growth);
    const int rows = RowsToFill(replaced, 1e-6, growth);
    const std::vector<double> ends = RowEnds(replaced, 1e-6, rows);
    const double last = ends.back() - ends[ends.size() - 2];
    EXPECT_LE(last, growth * 1.01) << growth;
    EXPECT_GE(last, 1.0 / growth / 1.05) << growth;
  }
}
}
}
