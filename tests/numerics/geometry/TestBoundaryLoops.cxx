#include "BoundaryLoops.h"
#include "Support.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace crossfield::test
{
namespace
{
using Segments = std::vector<std::array<int, 2>>;

struct Curves
{
  std::vector<Point> points;
  Segments segments;
};

/// Returns two squares and a triangle with randomly numbered points.
Curves MakeCurves(Random& random)
{
  const std::vector<Loop> loops = { RegularPolygon(4, 2.0), RegularPolygon(4, 1.0),
    RegularPolygon(3, 1.0, Point(5.0, 0.0)) };
  std::vector<int> place(11);
  std::iota(place.begin(), place.end(), 0);
  random.Shuffle(place);
  Curves curves;
  curves.points.resize(place.size());
  int first = 0;
  for (const Loop& loop : loops)
  {
    const int count = static_cast<int>(loop.size());
    for (int i = 0; i < count; ++i)
    {
      curves.points[place[first + i]] = loop[i];
      curves.segments.push_back({ place[first + i], place[first + (i + 1) % count] });
    }
    first += count;
  }
  return curves;
}

TEST(BoundaryLoops, ChainsEachLoopCompletely)
{
  Random random(1);
  for (int trial = 0; trial < 20; ++trial)
  {
    const Curves curves = MakeCurves(random);
    std::vector<double> areas;
    for (const Loop& loop : ChainLoops(curves.points, curves.segments))
    {
      areas.push_back(std::abs(SignedArea(loop)));
    }
    std::sort(areas.begin(), areas.end());
    ASSERT_EQ(areas.size(), 3u);
    EXPECT_NEAR(areas[0], 0.75 * std::sqrt(3.0), 1e-14);
    EXPECT_NEAR(areas[1], 2.0, 1e-14);
    EXPECT_NEAR(areas[2], 8.0, 1e-14);
  }
}

TEST(BoundaryLoops, IgnoresOrderDirectionAndRepetitionOfSegments)
{
  Random random(2);
  const Curves curves = MakeCurves(random);
  const std::vector<Loop> expected = ChainLoops(curves.points, curves.segments);
  for (int trial = 0; trial < 50; ++trial)
  {
    Segments segments = curves.segments;
    for (auto& segment : segments)
    {
      if (random.Integer(0, 1) == 1)
      {
        std::swap(segment[0], segment[1]);
      }
    }
    for (int i = 0; i < 5; ++i)
    {
      const auto& again = segments[random.Integer(0, 10)];
      segments.push_back({ again[1], again[0] });
    }
    const int point = random.Integer(0, 10);
    segments.push_back({ point, point });
    random.Shuffle(segments);
    EXPECT_EQ(ChainLoops(curves.points, segments), expected);
  }
}

TEST(BoundaryLoops, IgnoresPointsWithoutSegments)
{
  const std::vector<Point> points = { { 9.0, 9.0 }, { 0.0, 0.0 }, { 1.0, 0.0 },
    { std::numeric_limits<double>::quiet_NaN(), 0.0 }, { 0.0, 1.0 } };
  const std::vector<Loop> loops = ChainLoops(points, { { 1, 2 }, { 2, 4 }, { 4, 1 } });
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_EQ(loops[0].size(), 3u);
  EXPECT_TRUE(ChainLoops(points, {}).empty());
}

TEST(BoundaryLoops, RefusesAnOpenCurveAndNamesItsEnd)
{
  const std::vector<Point> points = { { 0.5, 0.25 }, { 1.0, 0.0 }, { 1.0, 1.0 } };
  EXPECT_TRUE(Refuses(
    [&] {
      ChainLoops(points, { { 0, 1 }, { 1, 2 } });
    },
    { "open curve", "(0.5, 0.25)", "join" }));
  // A segment and its reverse are not a loop.
  EXPECT_TRUE(Refuses([&] { ChainLoops(points, { { 0, 1 }, { 1, 0 } }); }, { "open curve" }));
}

TEST(BoundaryLoops, RefusesABranchAndNamesItsPosition)
{
  std::vector<Point> points = RegularPolygon(4);
  points[2] = { -1.5, 0.125 };
  const Segments diagonal = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 0, 2 } };
  EXPECT_TRUE(Refuses([&] { ChainLoops(points, diagonal); }, { "branches", "(1, 0)" }));
  points.emplace_back(-3.0, 0.0);
  const Segments spur = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 2, 4 } };
  EXPECT_TRUE(Refuses([&] { ChainLoops(points, spur); }, { "branches", "(-1.5, 0.125)" }));
}

TEST(BoundaryLoops, RefusesCoordinatesThatAreNotFinite)
{
  for (const double bad : { std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity() })
  {
    for (int axis : { 0, 1 })
    {
      std::vector<Point> points = RegularPolygon(3);
      points[1][axis] = bad;
      EXPECT_TRUE(Refuses(
        [&] {
          ChainLoops(points, { { 0, 1 }, { 1, 2 }, { 2, 0 } });
        },
        { "not finite" }));
    }
  }
}
}
}
