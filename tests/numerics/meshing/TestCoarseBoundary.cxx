#include "CoarseBoundary.h"

#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
bool Has(const Loop& loop, const Point& point)
{
  return std::find(loop.begin(), loop.end(), point) != loop.end();
}

TEST(CoarseBoundary, CircleIsWithinAThousandthOfTheLength)
{
  const Loop circle = RegularPolygon(40000);
  const double length = 0.04;
  const PlanarDomain coarse =
    CoarsenBoundary({ { circle } }, length, DefaultCornerAngle, { { circle[17], 1 } });
  ASSERT_EQ(coarse.loops.size(), 1u);
  const Loop& loop = coarse.loops[0];
  EXPECT_TRUE(Has(loop, circle[17]));
  // The height of an arc over a chord c is c²/8.
  EXPECT_NEAR(static_cast<double>(loop.size()), 2.0 * Pi / std::sqrt(8.0 * 1e-3 * length), 4.0);
  for (std::size_t i = 0; i < circle.size(); i += 7)
  {
    EXPECT_LE(DistanceToLoop(circle[i], loop), 1e-3 * length * (1.0 + 1e-9));
  }
}

TEST(CoarseBoundary, CornersKeepTheirAnglesAndStraightSidesTheLength)
{
  // A square with a thousand vertices per side, and a hole with few sides.
  Loop square;
  const Loop corners = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } };
  for (std::size_t side = 0; side < 4; ++side)
  {
    for (int i = 0; i < 1000; ++i)
    {
      square.push_back(corners[side] + 0.001 * i * (corners[(side + 1) % 4] - corners[side]));
    }
  }
  Loop hole = RegularPolygon(6, 0.2, { 0.5, 0.5 });
  std::reverse(hole.begin(), hole.end());
  const PlanarDomain coarse = CoarsenBoundary({ { square, hole } }, 0.1, DefaultCornerAngle, {});
  EXPECT_EQ(coarse.loops[1], hole);
  for (const Point& corner : corners)
  {
    EXPECT_TRUE(Has(coarse.loops[0], corner));
  }
  EXPECT_LT(coarse.loops[0].size(), 60u);
  EXPECT_NEAR(SignedArea(coarse.loops[0]), 1.0, 1e-12);
  for (std::size_t i = 0; i < coarse.loops[0].size(); ++i)
  {
    const Point& next = coarse.loops[0][(i + 1) % coarse.loops[0].size()];
    EXPECT_LE((next - coarse.loops[0][i]).norm(), 0.1 + 1e-12);
  }
}

TEST(CoarseBoundary, LeavesLoopsThatWouldTouchUnchanged)
{
  // An island whose vertices are between the circle and the chords of a coarser polygon.
  const Loop circle = RegularPolygon(3000);
  Loop island = RegularPolygon(300, 1.0 - 2e-5);
  std::reverse(island.begin(), island.end());
  const PlanarDomain domain = { { circle, island } };
  EXPECT_EQ(CoarsenBoundary(domain, 0.04, DefaultCornerAngle, {}).loops, domain.loops);
}
}
}
