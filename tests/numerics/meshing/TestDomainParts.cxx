// Connected parts of boundary loops.

#include "DomainParts.h"
#include "MakePlanarDomain.h"
#include "SegmentSearch.h"
#include "Support.h"

#include <algorithm>

namespace crossfield::test
{
namespace
{
Loop BoxOf(double x, double y, double width, double height)
{
  return { { x, y }, { x + width, y }, { x + width, y + height }, { x, y + height } };
}

TEST(DomainParts, AreSortedByAreaAndHaveTheirHoles)
{
  // A plate with two holes, an island in one of them, and a plate beside it.
  std::vector<Loop> loops = { BoxOf(20, 0, 3, 3), BoxOf(2, 2, 1, 1), BoxOf(0, 0, 10, 10),
    BoxOf(1, 1, 3, 3), BoxOf(6, 6, 2, 2), BoxOf(21, 1, 1, 1) };
  const auto check = [&]
  {
    const std::vector<PlanarDomain> parts = SplitParts(loops);
    ASSERT_EQ(parts.size(), 3U);
    EXPECT_NEAR(parts[0].Area(), 100.0 - 9.0 - 4.0, 1e-12);
    EXPECT_EQ(parts[0].loops.size(), 3U);
    EXPECT_NEAR(parts[1].Area(), 9.0 - 1.0, 1e-12);
    EXPECT_NEAR(parts[2].Area(), 1.0, 1e-12);
  };
  check();
  std::reverse(loops.begin(), loops.end());
  for (Loop& loop : loops)
  {
    std::reverse(loop.begin(), loop.end());
    check();
  }
  EXPECT_TRUE(Refuses([&] { MakePlanarDomain(loops); }, { "3 parts", "--part" }));
  EXPECT_TRUE(Refuses([] { SplitParts({}); }, { "no boundary" }));
}

TEST(DomainParts, OfTheSameAreaAreSortedFromLeftToRight)
{
  // Rounding and simplified boundaries do not change their order.
  const std::vector<PlanarDomain> parts = SplitParts(
    { BoxOf(6, 0, 1, 1.0001), BoxOf(3, 0, 1, 0.9999), BoxOf(0, 0, 1, 1), BoxOf(9, 0, 2, 1) });
  ASSERT_EQ(parts.size(), 4U);
  for (int p = 0; p < 4; ++p)
  {
    EXPECT_TRUE(SegmentSearch(parts[static_cast<std::size_t>(p)])
                  .SignedDistance(Point(p == 0 ? 9.5 : 3.0 * p - 2.5, 0.5)) > 0.0)
      << p;
  }
}

TEST(DomainParts, HaveNumbers)
{
  EXPECT_EQ(PartOf("largest", 3), 0);
  EXPECT_EQ(PartOf("1", 3), 0);
  EXPECT_EQ(PartOf("3", 3), 2);
  EXPECT_EQ(PartOf("outer", 3), -1);
  EXPECT_EQ(PartOf("3b", 3), -1);
  EXPECT_TRUE(Refuses([] { PartOf("4", 3); }, { "no part 4", "3 parts" }));
  EXPECT_TRUE(Refuses([] { PartOf("0", 1); }, { "1 part." }));
}
}
}
