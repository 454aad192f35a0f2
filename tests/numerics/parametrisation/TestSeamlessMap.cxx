#include "SeamlessMapSolve.h"

#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "SeamlessMapChecks.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
SeamlessMap MapOf(const PlanarDomain& domain, const Configuration& configuration, double meshSize,
  const SeamlessMapOptions& options = {})
{
  return SolveSeamlessMap(
    ShareTopology(MeshThroughPoints(domain, configuration, meshSize)), configuration, options);
}

const Configuration Four = OnCircle(4, 0.6, Pi / 4.0, 1, 0.0);

TEST(SeamlessMap, ClosesAtSeamsAndSides)
{
  const SeamlessMap map = MapOf(Builtin("disk", 0.05), Four, 0.05);
  EXPECT_EQ(SeamDefect(map), 0.0);
  double area = 0.0;
  for (int t = 0; t < static_cast<int>(map.corners.size()); ++t)
  {
    area += 0.5 * Cross(map.At(t, 1) - map.At(t, 0), map.At(t, 2) - map.At(t, 0));
  }
  EXPECT_NEAR(area, MeshArea(map.topology->mesh), 1e-10);
}

TEST(SeamlessMap, IsAnIsometryOnTheSquare)
{
  const SeamlessMap map = MapOf(Builtin("square"), {}, 0.2);
  EXPECT_LT(map.residual, 1e-7); // the root of a difference between numbers of order 1
  const Point first = map.points.front();
  const SpacePoint place = map.topology->PositionOf(map.original.front());
  for (std::size_t p = 0; p < map.points.size(); ++p)
  {
    const SpacePoint moved = map.topology->PositionOf(map.original[p]) - place;
    EXPECT_NEAR((map.points[p] - first).norm(), moved.norm(), 1e-9);
  }
}

TEST(SeamlessMap, ConvergesToAConformalMap)
{
  std::vector<double> sizes;
  std::vector<double> residuals;
  for (const double size : { 0.1, 0.07, 0.05, 0.035 })
  {
    sizes.push_back(size);
    residuals.push_back(MapOf(Builtin("disk", size), Four, size).residual);
  }
  // h √log(R / 6h): on meshes as coarse as these the logarithm reduces the order by a third
  // (docs/method.md §12.3).
  EXPECT_GT(ConvergenceRate(sizes, residuals), 0.5);
}

TEST(SeamlessMap, IsInjectiveOnCoarseMeshes)
{
  for (const double size : { 0.5, 0.3, 0.2 })
  {
    EXPECT_EQ(SeamDefect(MapOf(Builtin("disk", size), Four, size)), 0.0);
  }
}

TEST(SeamlessMap, AcceptsIndicesTwoAndMinusThree)
{
  const SeamlessMap two =
    MapOf(Builtin("disk", 0.05), { { { 0.5, 0.1 }, 2 }, { { -0.5, -0.1 }, 2 } }, 0.05);
  EXPECT_EQ(SeamDefect(two), 0.0);
  Configuration many = OnCircle(7, 0.7, 0.1, 1, 0.0);
  many.push_back({ { 0.0, 0.0 }, -3 });
  EXPECT_EQ(SeamDefect(MapOf(Builtin("disk", 0.05), many, 0.05)), 0.0);
}

/// Positive singularities on the left and negative ones on the right: sizes grow by more than 1e7
/// from one side to the other, and the range of the weights exceeds the precision of doubles.
TEST(SeamlessMap, IsInjectiveForSizesOverSevenOrdersOfMagnitude)
{
  Configuration configuration = { { { -0.9, 0.0 }, 1 }, { { -0.7, 0.6 }, 1 }, { { -0.7, -0.6 }, 1 },
    { { -0.2, 0.9 }, 1 } };
  constexpr double Apart = 0.24;
  for (int column = 0; column < 4; ++column)
  {
    for (int row = -3; row <= 3; ++row)
    {
      const Point place(Apart * (column - 3.5), Apart * row + 0.02 * column);
      if (place.norm() < 0.85)
      {
        configuration.push_back({ place, 1 });
        configuration.push_back({ { -place.x(), place.y() }, -1 });
      }
    }
  }
  const SeamlessMap map = MapOf(Builtin("disk", 0.03), configuration, 0.03);
  std::vector<double> sizes;
  for (std::size_t t = 0; t < map.corners.size(); ++t)
  {
    const int number = static_cast<int>(t);
    const double mapped =
      Cross(map.At(number, 1) - map.At(number, 0), map.At(number, 2) - map.At(number, 0));
    sizes.push_back(std::sqrt(2.0 * TriangleArea(map.topology->mesh, t) / mapped));
  }
  std::sort(sizes.begin(), sizes.end());
  EXPECT_GT(sizes.back() / sizes.front(), 1e7);
  EXPECT_EQ(SeamDefect(map), 0.0);
}

TEST(SeamlessMap, IsInjectiveWithSmallHolonomyDefects)
{
  // The defect of a ring is Σ k_j arg b_j (docs/method.md §7.3), up to 0.1 radians of the cross
  // here.
  const PlanarDomain ring = Builtin("ring", 0.05);
  for (const double turn : { 0.02, 0.05, 0.1 })
  {
    SCOPED_TRACE(turn);
    Configuration configuration = OnCircle(4, 0.8, 0.1, 1, 0.0);
    const Configuration inner = OnCircle(4, 0.6, 0.1 + turn, -1, 0.0);
    configuration.insert(configuration.end(), inner.begin(), inner.end());
    const SeamlessMap map = MapOf(ring, configuration, 0.05);
    ASSERT_EQ(map.holonomyDefect.size(), 1U);
    EXPECT_NEAR(std::abs(map.holonomyDefect[0]), 4.0 * turn, 0.05);
    EXPECT_EQ(SeamDefect(map), 0.0);
  }
}

TEST(SeamlessMap, RefusesConfigurationsWithoutMap)
{
  const PlanarDomain disk = Builtin("disk", 0.1);
  EXPECT_TRUE(Refuses(
    [&] {
      MapOf(disk, { { { 0.3, 0.0 }, 3 }, { { -0.3, 0.0 }, 1 } }, 0.1);
    },
    { "quarter index 3", "split it" }));
  EXPECT_TRUE(Refuses(
    [&] {
      MapOf(disk, { { { 0.3, 0.0 }, 1 } }, 0.1);
    },
    { "add up to 1" }, Error::Kind::Inconsistent));
  EXPECT_TRUE(Refuses(
    [&] {
      MapOf(disk, Join(OnCircle(3, 0.6, 0.3, 1, 0.0), { { { 1.3, 0.2 }, 1 } }), 0.1);
    },
    { "outside the domain" }));
  // A mesh without vertices at the singularities.
  const TriangleMesh mesh = MeshForPoints(disk, {}, 0.3);
  EXPECT_TRUE(
    Refuses([&] { SolveSeamlessMap(ShareTopology(mesh), OnCircle(4, 0.511, 0.3, 1, 0.0)); },
      { "at no vertex", "give the domain" }));
  // The smallest rotation at a corner of 20° has index 2.
  const double height = std::tan(10.0 / 180.0 * Pi);
  const PlanarDomain wedge =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 1.0, -height }, { 1.0, height } } });
  EXPECT_TRUE(Refuses([&] { MapOf(wedge, {}, 0.03); }, { "quarter index 2", "cap corners" }));
  SeamlessMapOptions capped;
  capped.capCorners = true;
  EXPECT_EQ(SeamDefect(MapOf(wedge, { { { 0.5, 0.0 }, 1 } }, 0.03, capped)), 0.0);
}
}
}
