#include "LayoutDesign.h"
#include "LayoutSnap.h"
#include "NearMisses.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
Configuration AroundTwo(double turn)
{
  Configuration configuration;
  for (int i = 0; i < 6; ++i)
  {
    const double angle = turn + Pi * i / 3.0;
    configuration.push_back({ 0.7 * Point(std::cos(angle), std::sin(angle)), 1 });
  }
  configuration.push_back({ { 0.2, 0.0 }, -1 });
  configuration.push_back({ { -0.2, 0.0 }, -1 });
  return configuration;
}

TEST(LayoutSnap, JoinsNearMisses)
{
  const FactoredDomain disk(Builtin("disk", 0.07), {}, 0.07);
  // Four singularities close to a square, the fourth side of which follows from the other three.
  Random random(3);
  for (int i = 0; i < 3; ++i)
  {
    SCOPED_TRACE(i);
    Configuration four;
    for (int j = 0; j < 4; ++j)
    {
      const double angle = 0.2 + 0.5 * Pi * j;
      four.push_back({ 0.6 * Point(std::cos(angle), std::sin(angle)) +
          0.015 * Point(random.Uniform(-1, 1), random.Uniform(-1, 1)),
        1 });
    }
    const LayoutDesign before = DesignLayout(disk, four);
    ASSERT_EQ(before.mesh.headOn, 0);
    const LayoutSnap snap = SnapLayout(disk, four, {}, 0.1);
    EXPECT_GE(snap.joined, 3);
    EXPECT_EQ(snap.leftOut, 0);
    EXPECT_LE(snap.largestMove, 0.05);
    const LayoutDesign after = DesignLayout(disk, snap.singularities);
    // These are the sides of the square in the middle.
    EXPECT_EQ(after.mesh.headOn, 4);
    EXPECT_LT(after.mesh.patches.size(), before.mesh.patches.size());
    EXPECT_GT(after.shortestArc, 0.2);
    // Snapping again changes nothing.
    const LayoutSnap again = SnapLayout(disk, snap.singularities, {}, 0.1);
    EXPECT_EQ(again.joined, 0);
    EXPECT_EQ(again.largestMove, 0.0);
  }
}

TEST(LayoutSnap, RespectsTolerance)
{
  const FactoredDomain disk(Builtin("disk", 0.07), {}, 0.07);
  const Configuration start = AroundTwo(0.1);
  // No separatrix is that close to a singularity.
  const LayoutSnap none = SnapLayout(disk, start, {}, 1e-6);
  EXPECT_EQ(none.joined, 0);
  for (std::size_t i = 0; i < start.size(); ++i)
  {
    EXPECT_EQ(none.singularities[i].position, start[i].position);
  }
  const LayoutSnap some = SnapLayout(disk, start, {}, 0.08);
  EXPECT_GT(some.joined, 0);
  EXPECT_LE(some.largestMove, 0.08);
  const LayoutDesign before = DesignLayout(disk, start);
  const LayoutDesign after = DesignLayout(disk, some.singularities);
  EXPECT_GT(after.mesh.headOn, before.mesh.headOn);
}

TEST(LayoutSnap, AcceptsNoSingularities)
{
  // An L has no singularity that could move.
  const FactoredDomain domain(Builtin("l-shape", 0.1), {}, 0.1);
  double last = 0.0;
  const LayoutSnap snap = SnapLayout(domain, {}, {}, 10.0,
    Progress(
      [&last](double fraction)
      {
        EXPECT_GE(fraction, last);
        last = fraction;
        return true;
      }));
  EXPECT_EQ(snap.joined, 0);
  EXPECT_TRUE(snap.singularities.empty());
  EXPECT_EQ(last, 1.0);
}

TEST(LayoutSnap, OffsetsMatchTracedDistances)
{
  // The absolute offset of a near miss is the length on the separatrix that is hit.
  const FactoredDomain disk(Builtin("disk", 0.07), {}, 0.07);
  const LayoutDesign design = DesignLayout(disk, AroundTwo(0.1));
  const std::vector<NearMiss> misses = FindNearMisses(design.separatrices, 0.1);
  ASSERT_FALSE(misses.empty());
  for (const NearMiss& miss : misses)
  {
    EXPECT_NEAR(std::abs(miss.Offset(design.map)), miss.across, 1e-12);
  }
}
}
}
