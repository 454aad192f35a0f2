#include "HilbertOrder.h"
#include "Support.h"

#include <algorithm>
#include <numeric>

namespace crossfield::test
{
namespace
{
TEST(HilbertOrder, GoesThroughASquareGridFromNeighbourToNeighbour)
{
  constexpr int Side = 32;
  std::vector<Point> points;
  for (int i = 0; i < Side * Side; ++i)
  {
    points.emplace_back(i % Side, i / Side);
  }
  Random(91).Shuffle(points);
  const std::vector<int> order = HilbertOrder(points);
  ASSERT_EQ(order.size(), points.size());
  for (std::size_t i = 1; i < order.size(); ++i)
  {
    EXPECT_EQ((points[order[i]] - points[order[i - 1]]).norm(), 1.0);
  }
}

TEST(HilbertOrder, EveryPointIsThereOnceAndEqualOnesKeepTheirOrder)
{
  Random random(92);
  std::vector<Point> points;
  for (int i = 0; i < 500; ++i)
  {
    points.emplace_back(random.Uniform(-3.0, 1.0), random.Uniform(5.0, 6.0));
    points.push_back(points.back());
  }
  std::vector<int> order = HilbertOrder(points);
  for (std::size_t i = 0; i < order.size(); i += 2)
  {
    EXPECT_EQ(order[i] + 1, order[i + 1]);
  }
  std::sort(order.begin(), order.end());
  std::vector<int> all(points.size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(order, all);
  EXPECT_TRUE(HilbertOrder({}).empty());
}
}
}
