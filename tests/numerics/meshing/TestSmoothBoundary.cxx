#include "SmoothBoundary.h"

#include "BoundaryCorners.h"
#include "Support.h"

#include "Error.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace crossfield::test
{
namespace
{
/// Returns the unit circle with `waves` waves around it.
Loop WavyCircle(int waves, double height, int count)
{
  Loop loop = RegularPolygon(count);
  for (Point& point : loop)
  {
    point *= 1.0 + height * std::cos(waves * std::atan2(point.y(), point.x()));
  }
  return loop;
}

/// Returns half of the range of radii of a loop around the origin.
double Height(const Loop& loop)
{
  double least = 1e300;
  double most = 0.0;
  for (const Point& point : loop)
  {
    least = std::min(least, point.norm());
    most = std::max(most, point.norm());
  }
  return 0.5 * (most - least);
}

TEST(SmoothBoundary, RemovesShortWavesAndRetainsLongOnes)
{
  // The filter 2 G − G² with G = exp(−2π² (0.4 L / wave)²) retains 8 %, 70 % and 97 %.
  const double height = 4e-3;
  for (const auto& [lengths, kept] : { std::pair{ 1.0, 0.083 }, { 2.0, 0.702 }, { 4.0, 0.967 } })
  {
    const int waves = 40;
    const double length = 2.0 * Pi / waves / lengths;
    const SimplifiedBoundary smooth =
      SmoothBoundary({ { WavyCircle(waves, height, 4000) } }, length);
    EXPECT_NEAR(Height(smooth.domain.loops[0]), kept * height, 0.03 * height) << lengths;
    EXPECT_NEAR(smooth.moved, (1.0 - kept) * height, 0.08 * height) << lengths;
  }
}

TEST(SmoothBoundary, LeavesSmoothBoundariesUnchanged)
{
  Loop ellipse = RegularPolygon(400);
  for (Point& point : ellipse)
  {
    point.y() *= 0.8;
  }
  const PlanarDomain domain{ { { { -2.0, -1.0 }, { 2.0, -1.0 }, { 2.0, 1.0 }, { -2.0, 1.0 } },
    { ellipse.rbegin(), ellipse.rend() } } };
  const SimplifiedBoundary same = SmoothBoundary(domain, 0.1);
  EXPECT_LT(same.moved, 1e-15);
  EXPECT_EQ(same.domain.loops[0].size(), 4U);
  EXPECT_EQ(same.domain.loops[1].size(), ellipse.size());
}

TEST(SmoothBoundary, SmoothsARaggedSideAndRetainsCorners)
{
  std::mt19937 engine(5);
  std::uniform_real_distribution<double> jump(-0.01, 0.01);
  Loop loop{ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 } };
  for (int i = 99; i > 0; --i)
  {
    loop.emplace_back(0.01 * i, 1.0 + (i > 90 || i < 10 ? 0.0 : jump(engine)));
  }
  loop.emplace_back(0.0, 1.0);
  EXPECT_GT(FindCorners({ loop }).size(), 40U);
  const SimplifiedBoundary smooth = SmoothBoundary({ { loop } }, 0.08);
  const std::vector<Corner> corners = FindCorners(smooth.domain.loops);
  ASSERT_EQ(corners.size(), 4U);
  for (const Corner& corner : corners)
  {
    EXPECT_NEAR((corner.position - Point(0.5, 0.5)).norm(), std::sqrt(0.5), 1e-12);
    EXPECT_NEAR(corner.angle, 0.5 * Pi, 0.02); // tolerance: half a wave of the ragged side
  }
  EXPECT_GT(smooth.moved, 0.005);
  EXPECT_LT(smooth.moved, 0.02);
  for (const Point& point : loop)
  {
    EXPECT_LE(DistanceToLoop(point, smooth.domain.loops[0]), smooth.moved * (1.0 + 1e-9) + 1e-15);
  }
}

TEST(SmoothBoundary, RetainsGivenPoints)
{
  const Loop loop = WavyCircle(40, 1e-2, 4000);
  const Loop smooth = SmoothBoundary({ { loop } }, 0.15, { loop[123] }).domain.loops[0];
  EXPECT_LT(DistanceToLoop(loop[123], smooth), 1e-12);
  EXPECT_GT(DistanceToLoop(loop[0], smooth), 1e-3);
}

TEST(SmoothBoundary, RefusesToCrossOtherLoops)
{
  // A hole in the tip of a spike that smoothing removes.
  const PlanarDomain domain{ { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.55, 1.0 },
                                 { 0.5, 1.1 }, { 0.45, 1.0 }, { 0.0, 1.0 } },
    { { 0.5, 1.07 }, { 0.505, 1.06 }, { 0.495, 1.06 } } } };
  EXPECT_THROW(SmoothBoundary(domain, 0.3), Error);
}
}
}
