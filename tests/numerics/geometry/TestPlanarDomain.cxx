#include "MakePlanarDomain.h"
#include "PlanarDomain.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
Loop Box(double x0, double y0, double x1, double y1)
{
  return { { x0, y0 }, { x1, y0 }, { x1, y1 }, { x0, y1 } };
}

Loop Reversed(Loop loop)
{
  std::reverse(loop.begin(), loop.end());
  return loop;
}

TEST(PlanarDomain, SignedAreaDependsOnOrientationNotOnPosition)
{
  EXPECT_DOUBLE_EQ(SignedArea(Box(0.0, 0.0, 3.0, 2.0)), 6.0);
  EXPECT_DOUBLE_EQ(SignedArea(Reversed(Box(0.0, 0.0, 3.0, 2.0))), -6.0);
  // Products of absolute coordinates would cancel entirely for an area of 1 at 1e9.
  EXPECT_DOUBLE_EQ(SignedArea(Box(1e9, -1e9, 1e9 + 1.0, -1e9 + 1.0)), 1.0);
  EXPECT_DOUBLE_EQ(BoundingDiagonal({ Box(-1.0, 2.0, 2.0, 6.0) }), 5.0);
  EXPECT_DOUBLE_EQ(BoundingDiagonal({}), 0.0);
}

TEST(PlanarDomain, OrientsAndNestsLoopsInAnyOrder)
{
  const Loop outer = Box(0.0, 0.0, 10.0, 10.0);
  const Loop first = Box(1.0, 1.0, 3.0, 3.0);
  const Loop second = RegularPolygon(7, 1.5, Point(7.0, 7.0));
  const double area = 100.0 - 4.0 - SignedArea(second);
  for (int reversals = 0; reversals < 8; ++reversals)
  {
    for (std::size_t position = 0; position < 3; ++position)
    {
      std::vector<Loop> loops = { first, second };
      loops.insert(loops.begin() + position, outer);
      for (std::size_t i = 0; i < 3; ++i)
      {
        loops[i] = (reversals >> i & 1) != 0 ? Reversed(loops[i]) : loops[i];
      }
      const PlanarDomain domain = MakePlanarDomain(loops);
      ASSERT_EQ(domain.loops.size(), 3u);
      EXPECT_DOUBLE_EQ(SignedArea(domain.loops[0]), 100.0);
      EXPECT_LT(SignedArea(domain.loops[1]), 0.0);
      EXPECT_LT(SignedArea(domain.loops[2]), 0.0);
      EXPECT_NEAR(domain.Area(), area, 1e-12);
      EXPECT_EQ(domain.EulerCharacteristic(), -1);
    }
  }
}

TEST(PlanarDomain, CommutesWithScalingAndTranslation)
{
  // Rotated, so that the leftmost point of each loop is unique by more than rounding.
  const std::vector<Loop> loops = Similarity{ 0.3, 1.0, Point::Zero() }(
    std::vector<Loop>{ Reversed(RegularPolygon(9, 0.2, Point(0.3, 0.3))), RegularPolygon(41),
      RegularPolygon(5, 0.1, Point(-0.5, 0.1)) });
  const PlanarDomain plain = MakePlanarDomain(loops);
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    for (const Point& shift : { Point(0.0, 0.0), Point(-4.0, 7.0), Point(1e6, 1e6) })
    {
      const Similarity move{ 0.0, scale, scale * shift };
      const PlanarDomain moved = MakePlanarDomain(move(loops));
      ASSERT_EQ(moved.loops.size(), plain.loops.size());
      for (std::size_t i = 0; i < plain.loops.size(); ++i)
      {
        EXPECT_EQ(moved.loops[i], move(plain.loops[i]));
      }
      EXPECT_NEAR(moved.Area() / (scale * scale), plain.Area(), 1e-8);
      EXPECT_NEAR(moved.Diagonal() / scale, move(plain).Diagonal() / scale, 1e-8);
    }
  }
}

TEST(PlanarDomain, TheSameCurvesGiveTheSameDomain)
{
  Random random(5);
  std::vector<Loop> loops = { RegularPolygon(12, 5.0) };
  for (int i = 0; i < 6; ++i)
  {
    loops.push_back(
      RegularPolygon(4 + i, 0.5, 3.0 * Point(std::cos(Pi * i / 3.0), std::sin(Pi * i / 3.0))));
  }
  const PlanarDomain expected = MakePlanarDomain(loops);
  for (int trial = 0; trial < 30; ++trial)
  {
    for (Loop& loop : loops)
    {
      const int first = random.Integer(0, static_cast<int>(loop.size()) - 1);
      std::rotate(loop.begin(), loop.begin() + first, loop.end());
      loop = random.Integer(0, 1) == 0 ? loop : Reversed(loop);
    }
    random.Shuffle(loops);
    EXPECT_EQ(MakePlanarDomain(loops).loops, expected.loops);
  }
}

TEST(PlanarDomain, DetectsTouchingExactly)
{
  // A gap of one unit in the last place between an inner loop and the outer one is sufficient.
  const double gap = std::nextafter(10.0, 0.0);
  EXPECT_NO_THROW(MakePlanarDomain({ Box(0.0, 0.0, 10.0, 10.0), Box(gap - 1.0, 4.0, gap, 5.0) }));
}

TEST(PlanarDomain, RefusesLoopsThatCross)
{
  for (const double scale : { 1e-6, 1.0, 1e6 })
  {
    const Similarity move{ 0.7, scale, Point::Zero() };
    // Two loops that cross each other, and one that crosses itself.
    const std::vector<Loop> two = { Box(0, 0, 2, 2), Box(1, 1, 3, 3) };
    EXPECT_TRUE(Refuses([&] { MakePlanarDomain(move(two)); }, { "crosses" }));
    const Loop bow = { { 0, 0 }, { 2, 2 }, { 2, 0 }, { 0, 2 } };
    EXPECT_TRUE(Refuses([&] { MakePlanarDomain({ move(bow) }); }, { "crosses" }));
  }
}

TEST(PlanarDomain, RefusesLoopsThatTouch)
{
  const Loop outer = Box(0.0, 0.0, 10.0, 10.0);
  // Loops with a common vertex: an outer and an inner loop, and two inner loops.
  EXPECT_TRUE(Refuses(
    [&] {
      MakePlanarDomain({ outer, { { 0, 0 }, { 3, 1 }, { 1, 3 } } });
    },
    { "touches", "(0, 0)" }));
  EXPECT_TRUE(Refuses(
    [&] {
      MakePlanarDomain({ outer, Box(2, 2, 4, 4), Box(4, 4, 6, 6) });
    },
    { "touches", "(4, 4)" }));
  // A loop with a vertex on a segment of another loop.
  EXPECT_TRUE(Refuses(
    [&] {
      MakePlanarDomain({ outer, { { 5, 0 }, { 6, 1 }, { 4, 1 } } });
    },
    { "touches", "(5, 0)" }));
  EXPECT_TRUE(Refuses(
    [&] {
      MakePlanarDomain({ { { 5, 0 }, { 6, 1 }, { 4, 1 } }, outer });
    },
    { "touches", "(5, 0)" }));
  // Loops that share part of a segment, and two equal loops.
  EXPECT_TRUE(Refuses([&] { MakePlanarDomain({ outer, Box(10, 2, 12, 4) }); }, { "touches" }));
  EXPECT_TRUE(Refuses([&] { MakePlanarDomain({ outer, outer }); }, { "touches" }));
  // A loop with a repeated point.
  EXPECT_TRUE(Refuses(
    [&] {
      MakePlanarDomain({ { { 0, 0 }, { 1, 0 }, { 1, 0 }, { 0, 1 } } });
    },
    { "touches", "(1, 0)" }));
}

TEST(PlanarDomain, RefusesDisconnectedDomains)
{
  EXPECT_TRUE(Refuses([] { MakePlanarDomain({}); }, { "no boundary" }));
  EXPECT_TRUE(Refuses(
    [] {
      MakePlanarDomain({ Box(0, 0, 1, 1), Box(2, 0, 3, 1) });
    },
    { "several outer loops" }));
  EXPECT_TRUE(Refuses(
    [] {
      MakePlanarDomain({ Box(3, 3, 4, 4), Box(0, 0, 9, 9), Box(2, 2, 6, 6) });
    },
    { "inner loop lies inside another" }));
}

TEST(PlanarDomain, RefusesLoopsThatEncloseNothing)
{
  EXPECT_TRUE(Refuses([] { MakePlanarDomain({ Loop{} }); }, { "fewer than three points" }));
  EXPECT_TRUE(Refuses(
    [] {
      MakePlanarDomain({ Box(0, 0, 9, 9), { { 1, 1 }, { 2, 2 } } });
    },
    { "fewer than three" }));
  // Loops whose points are on a line: a single one, and one inside another loop.
  EXPECT_TRUE(Refuses([] { MakePlanarDomain({ { { 0, 0 }, { 1, 1 }, { 2, 2 } } }); }, {}));
  EXPECT_TRUE(Refuses(
    [] {
      MakePlanarDomain({ Box(0, 0, 9, 9), { { 1, 1 }, { 3, 3 }, { 2, 2 } } });
    },
    {}));
}

TEST(PlanarDomain, RefusesCoordinatesThatAreNotFinite)
{
  for (const double bad :
    { std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity() })
  {
    Loop loop = Box(0.0, 0.0, 1.0, 1.0);
    loop[2].y() = bad;
    EXPECT_TRUE(Refuses([&] { MakePlanarDomain({ loop }); }, { "finite" }));
  }
}

TEST(PlanarDomain, RefusesExtentsWhosePowersOverflow)
{
  for (const double good : { 1.01e-60, 1.0, 0.99e60 })
  {
    EXPECT_NO_THROW(MakePlanarDomain({ Box(0.0, 0.0, good, 0.5 * good) }));
  }
  for (const double bad : { 1e-300, 0.99e-60, 1.01e60, 1e300 })
  {
    EXPECT_TRUE(Refuses([bad] { MakePlanarDomain({ Box(0.0, 0.0, bad, 0.5 * bad) }); },
      { "extent", "another unit of length" }));
  }
}
}
}
