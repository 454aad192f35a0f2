#include "LayoutClosing.h"
#include "Layouts.h"
#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Four singularities in the disk near a square.
Configuration NearSquare(double disturbance)
{
  Random random(3);
  Configuration four;
  for (int j = 0; j < 4; ++j)
  {
    const double angle = 0.2 + 0.5 * Pi * j;
    four.push_back({ 0.6 * Point(std::cos(angle), std::sin(angle)) +
        disturbance * Point(random.Uniform(-1, 1), random.Uniform(-1, 1)),
      1 });
  }
  return four;
}

ClosingOptions OptionsFor(const PlanarDomain& domain, double meshSize)
{
  ClosingOptions options;
  options.mesh = [&domain, meshSize](const Configuration& singularities, const Progress& progress)
  { return MeshThroughPoints(domain, singularities, meshSize, progress); };
  return options;
}

/// Returns the lengths of arcs below a bound, each in quads.
double LongestBelow(const TMesh& tMesh, double bound)
{
  double longest = 0.0;
  for (const TArc& arc : tMesh.arcs)
  {
    if (arc.length < bound)
    {
      longest = std::max(longest, arc.length);
    }
  }
  return longest;
}

TEST(LayoutClosing, SeparatricesThatNearlyMeetMeet)
{
  const PlanarDomain disk = Builtin("disk", 0.07);
  const Layout start = LayOutOn(disk, NearSquare(0.03), {}, 0.07);
  ClosingOptions options = OptionsFor(disk, 0.0);
  options.size = 0.1;
  options.coarseness = 3.0;
  const std::size_t arcs = FindArcsToClose(start.tMesh, options).size();
  EXPECT_GE(arcs, 6u); // sides of the square are pairs of separatrices
  EXPECT_GT(LongestBelow(start.tMesh, 0.1), 0.02 * options.size);
  const ClosingResult result = CloseLayout(disk, start, options);
  EXPECT_TRUE(result.converged);
  EXPECT_LE(result.maps, 4);
  EXPECT_LT(result.longest, 0.02);
  EXPECT_LT(LongestBelow(result.layout.tMesh, 0.1), 0.02 * options.size);
  // What is closed stays as it is.
  const ClosingResult again = CloseLayout(disk, result.layout, options);
  EXPECT_EQ(again.maps, 0);
  EXPECT_TRUE(again.converged);
}

TEST(LayoutClosing, ExactClosingEndsWhenSeparatricesMeet)
{
  const PlanarDomain disk = Builtin("disk", 0.07);
  const Layout start = LayOutOn(disk, NearSquare(0.03), {}, 0.07);
  ClosingOptions options = OptionsFor(disk, 0.07);
  options.size = 0.1;
  options.exact = true;
  options.maximumMaps = 40;
  const ClosingResult result = CloseLayout(disk, start, options);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(start.tMesh.headOn, 0);
  EXPECT_EQ(result.layout.tMesh.headOn, 4);
  EXPECT_EQ(result.longest, 0.0);
  const double move = LargestMove(start.singularities, result.layout.singularities);
  options.maximumMove = 0.5 * move;
  const ClosingResult limited = CloseLayout(disk, start, options);
  EXPECT_FALSE(limited.converged);
  EXPECT_LE(LargestMove(start.singularities, limited.layout.singularities), 0.5 * move);
}

TEST(LayoutClosing, ArcsBetweenCornersAreLeftAlone)
{
  // Without singularities inside nothing can move.
  const PlanarDomain domain = Builtin("l-shape", 0.25);
  const Layout start = LayOutOn(domain, {}, {}, 0.2);
  ClosingOptions options = OptionsFor(domain, 0.0);
  options.size = 1.5;
  options.coarseness = 4.0;
  const ClosingResult result = CloseLayout(domain, start, options);
  EXPECT_EQ(result.maps, 0);
  EXPECT_TRUE(result.layout.singularities.empty());
}

TEST(LayoutClosing, ReducesHolonomyDefects)
{
  // Around a hole in a square, four singularities that are not quite at equal distances.
  const Loop hole = { { 0.25, 0.0 }, { 0.177, -0.177 }, { 0.0, -0.25 }, { -0.177, -0.177 },
    { -0.25, 0.0 }, { -0.177, 0.177 }, { 0.0, 0.25 }, { 0.177, 0.177 } };
  const PlanarDomain plate = { { { { -1.0, -0.8 }, { 1.0, -0.8 }, { 1.0, 0.8 }, { -1.0, 0.8 } },
    hole } };
  SeamlessMapOptions map;
  for (const Point& corner : hole)
  {
    map.corners.push_back({ corner, 0 });
  }
  const Configuration four = { { { 0.37, 0.33 }, -1 }, { { -0.33, 0.36 }, -1 },
    { { -0.36, -0.34 }, -1 }, { { 0.34, -0.35 }, -1 } };
  const Layout start = LayOutOn(plate, four, map, 0.05);
  ClosingOptions options = OptionsFor(plate, 0.05);
  options.map = map;
  options.size = 0.05;
  const ClosingResult result = CloseLayout(plate, start, options);
  EXPECT_GT(result.maps, 0);
  // Radians of the phase, four times the tolerance of θ.
  EXPECT_GT(std::abs(start.map.holonomyDefect[0]), 0.1);
  EXPECT_LT(std::abs(result.layout.map.holonomyDefect[0]), 0.04);
}
}
}
