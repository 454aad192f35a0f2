#include "ThinBoundary.h"

#include "BoundaryCorners.h"
#include "BoundarySymmetry.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns a symmetric profile with a trailing edge of given thickness, clockwise inside a box;
/// cosine spacing from 1 to 0 and back.
PlanarDomain ProfileInBox(std::size_t half, double thickness)
{
  Loop upper;
  for (std::size_t i = 0; i <= half; ++i)
  {
    const double s =
      0.5 * (1.0 + std::cos(Pi * static_cast<double>(i) / static_cast<double>(half)));
    const double y = 0.6 *
        (0.2969 * std::sqrt(s) - 0.126 * s - 0.3516 * s * s + 0.2843 * s * s * s -
          0.1036 * s * s * s * s) +
      0.5 * thickness * s;
    upper.emplace_back(s, i == half ? 0.0 : y);
  }
  Loop profile;
  for (std::size_t i = 0; i < half; ++i)
  {
    profile.emplace_back(upper[i].x(), -upper[i].y());
  }
  profile.insert(profile.end(), upper.rbegin(), upper.rend());
  return { { { { -1.0, -1.0 }, { 3.0, -1.0 }, { 3.0, 1.0 }, { -1.0, 1.0 } }, profile } };
}

double ShortestSide(const Loop& loop)
{
  double shortest = 1e300;
  for (std::size_t i = 0; i < loop.size(); ++i)
  {
    shortest = std::min(shortest, (loop[(i + 1) % loop.size()] - loop[i]).norm());
  }
  return shortest;
}

bool HasVertex(const Loop& loop, const Point& place)
{
  return std::any_of(
    loop.begin(), loop.end(), [&](const Point& point) { return (point - place).norm() < 1e-12; });
}

TEST(ThinBoundary, DefaultLengthFollowsTheSmallerMeshSize)
{
  const PlanarDomain domain{ { RegularPolygon(4) } }; // in the unit circle
  const double usual = 0.02 * domain.Diagonal() / 40.0;
  EXPECT_DOUBLE_EQ(DefaultThinning(domain), usual);
  EXPECT_DOUBLE_EQ(DefaultThinning(domain, 0.01), 0.0002);
  EXPECT_DOUBLE_EQ(DefaultThinning(domain, 10.0), usual);
  EXPECT_THROW(DefaultThinning(domain, -1.0), Error);
}

TEST(ThinBoundary, LeavesLongSidesUnchanged)
{
  const PlanarDomain domain{ { RegularPolygon(96) } };
  const SimplifiedBoundary same = ThinBoundary(domain, 0.06);
  EXPECT_EQ(same.moved, 0.0);
  EXPECT_EQ(same.domain.loops, domain.loops);
}

TEST(ThinBoundary, CircleSidesAreBetweenHalfTheLengthAndTheLength)
{
  const double length = 0.02;
  // The outer loop is centred at the centre of the domain, the inner one is not.
  Loop hole = RegularPolygon(30001);
  std::reverse(hole.begin(), hole.end());
  for (Point& point : hole)
  {
    point = 0.3 * point + Point(0.4, 0.0);
  }
  const PlanarDomain domain{ { RegularPolygon(40000), hole } };
  const SimplifiedBoundary thin = ThinBoundary(domain, length);
  for (const Loop& loop : thin.domain.loops)
  {
    EXPECT_GT(ShortestSide(loop), 0.45 * length);
    EXPECT_LE((loop[1] - loop[0]).norm(), length);
  }
  // The height of an arc over a chord c is c²/8R, the maximum distance of a vertex from it.
  EXPECT_LE(thin.moved, length * length / (8.0 * 0.3));
  EXPECT_GT(thin.moved, 0.25 * length * length / 8.0);
  for (std::size_t i = 0; i < hole.size(); i += 17)
  {
    EXPECT_LE(DistanceToLoop(hole[i], thin.domain.loops[1]), thin.moved * (1.0 + 1e-9));
  }
}

TEST(ThinBoundary, MergesCloseCornersAndAddsTheirTurns)
{
  const double thickness = 1e-3;
  const PlanarDomain domain = ProfileInBox(2000, thickness);
  ASSERT_EQ(FindCorners(domain.loops).size(), 6U);
  const SimplifiedBoundary thin = ThinBoundary(domain, 0.002);
  const std::vector<Corner> corners = FindCorners(thin.domain.loops);
  ASSERT_EQ(corners.size(), 5U);
  EXPECT_LT((corners[4].position - Point(1.0, 0.0)).norm(), 1e-15);
  // A side of eight times the thickness that ends at the middle of the edge turns by a sixteenth.
  const std::vector<Corner> both = FindCorners(domain.loops);
  EXPECT_NEAR(corners[4].Turning(), both[4].Turning() + both[5].Turning(), 2.0 / 16.0);
  EXPECT_GE(thin.moved, 0.5 * thickness * 0.97);
  EXPECT_LE(thin.moved, 0.5 * thickness);
  EXPECT_LT(thin.domain.loops[1].size(), 2000U);
}

TEST(ThinBoundary, KeepsTheSymmetriesOfADomain)
{
  const double tolerance = 1e-12;
  for (const std::size_t half : { 2000U, 2001U })
  {
    const PlanarDomain profile = ThinBoundary(ProfileInBox(half, 1e-3), 0.002).domain;
    EXPECT_TRUE(FindSymmetries(profile, tolerance).reflects);
  }
  Loop ellipse = RegularPolygon(4002);
  for (Point& point : ellipse)
  {
    point.y() *= 0.5;
  }
  const PlanarDomain thin = ThinBoundary({ { ellipse } }, 0.02).domain;
  EXPECT_LT(thin.loops[0].size(), 800U);
  const SymmetryGroup group = FindSymmetries(thin, tolerance);
  EXPECT_EQ(group.order, 2);
  EXPECT_TRUE(group.reflects);
}

TEST(ThinBoundary, RetainsGivenPoints)
{
  const PlanarDomain domain = ProfileInBox(2000, 1e-3);
  const Point edge(1.0, 0.5e-3);
  const Point on = domain.loops[1][700];
  const Loop thin = ThinBoundary(domain, 0.002, { edge, on, { 0.5, 0.9 } }).domain.loops[1];
  EXPECT_TRUE(HasVertex(thin, edge));
  EXPECT_FALSE(HasVertex(thin, { 1.0, -0.5e-3 }));
  EXPECT_TRUE(HasVertex(thin, on));
  // Corners at two given points are not merged.
  const Loop both = ThinBoundary(domain, 0.002, { edge, { 1.0, -0.5e-3 } }).domain.loops[1];
  EXPECT_TRUE(HasVertex(both, edge));
  EXPECT_TRUE(HasVertex(both, { 1.0, -0.5e-3 }));
}

TEST(ThinBoundary, RetainsEndsOfChannels)
{
  // Four corners would become two cusps, and with the bend a loop would still remain.
  const PlanarDomain channel{ { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.999, 1.0 },
    { 0.999, 0.001 }, { 0.0, 0.001 } } } };
  const SimplifiedBoundary same = ThinBoundary(channel, 0.01);
  EXPECT_EQ(FindCorners(same.domain.loops).size(), 6U);
  EXPECT_EQ(same.moved, 0.0);
  // The chamfer of a corner is as short and is removed.
  const PlanarDomain chamfer{
    { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.999 }, { 0.999, 1.0 }, { 0.0, 1.0 } } }
  };
  const SimplifiedBoundary square = ThinBoundary(chamfer, 0.01);
  EXPECT_EQ(FindCorners(square.domain.loops).size(), 4U);
  EXPECT_NEAR(square.moved, 0.0005, 1e-6); // distance from the new sides
}

TEST(ThinBoundary, RemovesSmallStepsAndRetainsSmallHoles)
{
  // Corners of opposite turns cancel; the hole is smaller than the length.
  const PlanarDomain domain{
    { { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.5, 1.0 }, { 0.5, 1.001 }, { 0.0, 1.001 } },
      { { 0.5, 0.5 }, { 0.5, 0.501 }, { 0.501, 0.501 }, { 0.501, 0.5 } } }
  };
  const SimplifiedBoundary thin = ThinBoundary(domain, 0.01);
  EXPECT_EQ(thin.domain.loops[0].size(), 5U);
  EXPECT_TRUE(HasVertex(thin.domain.loops[0], { 0.5, 1.0005 }));
  EXPECT_NEAR(thin.moved, 0.0005, 1e-9);
  EXPECT_EQ(FindCorners({ thin.domain.loops[0] }).size(), 4U);
  EXPECT_EQ(thin.domain.loops[1].size(), 4U);
}
}
}
