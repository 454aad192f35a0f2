#include "LayoutDesign.h"
#include "LayoutSnap.h"
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
    ASSERT_EQ(before.layouts.Single().tMesh.headOn, 0);
    const LayoutSnap snap = SnapLayout(disk, four, {}, 0.1);
    EXPECT_NE(snap.event.find("5 patches instead of 9"), std::string::npos) << snap.event;
    EXPECT_EQ(snap.event.find("Others"), std::string::npos) << snap.event;
    EXPECT_GT(snap.largestMove, 0.0);
    EXPECT_LE(snap.largestMove, 0.05);
    const LayoutDesign after = DesignLayout(disk, snap.singularities);
    // These are the sides of the square in the middle.
    EXPECT_EQ(after.layouts.Single().tMesh.headOn, 4);
    EXPECT_EQ(after.layouts.Single().tMesh.patches.size(), 5u);
    EXPECT_GT(after.shortestArc, 0.2);
    // Snapping again changes nothing.
    const LayoutSnap again = SnapLayout(disk, snap.singularities, {}, 0.1);
    EXPECT_EQ(again.event, "No separatrices were joined.");
    EXPECT_EQ(again.largestMove, 0.0);
  }
}

TEST(LayoutSnap, RespectsTolerance)
{
  const FactoredDomain disk(Builtin("disk", 0.07), {}, 0.07);
  const Configuration start = AroundTwo(0.1);
  // No separatrix is that close to a singularity.
  const LayoutSnap none = SnapLayout(disk, start, {}, 1e-6);
  EXPECT_EQ(none.event, "No separatrices were joined.");
  for (std::size_t i = 0; i < start.size(); ++i)
  {
    EXPECT_EQ(none.singularities[i].position, start[i].position);
  }
  const LayoutSnap some = SnapLayout(disk, start, {}, 0.08);
  EXPECT_LE(some.largestMove, 0.08);
  const LayoutDesign before = DesignLayout(disk, start);
  const LayoutDesign after = DesignLayout(disk, some.singularities);
  EXPECT_EQ(before.layouts.Single().tMesh.headOn, 0);
  EXPECT_EQ(after.layouts.Single().tMesh.headOn, 5);
  // With less, the separatrices farthest apart are left as they are.
  const LayoutSnap few = SnapLayout(disk, start, {}, 0.6 * some.largestMove);
  EXPECT_LE(few.largestMove, 0.6 * some.largestMove);
}

TEST(LayoutSnap, KeepsSeparatricesThatMeet)
{
  const FactoredDomain disk(Builtin("disk", 0.07), {}, 0.07);
  const auto met = [&disk](const Configuration& singularities)
  { return DesignLayout(disk, singularities).layouts.Single().tMesh.headOn; };
  // With a small tolerance only some meet; these are kept while the others are joined.
  const Configuration some = SnapLayout(disk, AroundTwo(0.1), {}, 0.015).singularities;
  EXPECT_GE(met(some), 1);
  EXPECT_LT(met(some), 5);
  EXPECT_EQ(met(SnapLayout(disk, some, {}, 0.08).singularities), 5);
}

TEST(LayoutSnap, KeepsHolonomyDefects)
{
  // The grid lines around the hole of a ring do not close up, and the map is stretched.
  const FactoredDomain ring(Builtin("ring", 0.1), {}, 0.1);
  Configuration start;
  for (int i = 0; i < 4; ++i)
  {
    const double angle = 0.5 * Pi * i;
    start.push_back({ 0.8 * Point(std::cos(angle), std::sin(angle)), 1 });
    start.push_back({ 0.55 * Point(std::cos(angle + 0.6), std::sin(angle + 0.6)), -1 });
  }
  start[0].position += Point(0.0, 0.016);
  const LayoutDesign before = DesignLayout(ring, start);
  const Layout& first = before.layouts.Single();
  ASSERT_TRUE(first.map.flattening);
  const LayoutSnap snap = SnapLayout(ring, start, {}, 0.03);
  EXPECT_GT(snap.largestMove, 0.0);
  const LayoutDesign after = DesignLayout(ring, snap.singularities);
  const Layout& last = after.layouts.Single();
  EXPECT_NEAR(last.map.holonomyDefect[0], first.map.holonomyDefect[0], 1e-6);
  EXPECT_GT(last.tMesh.headOn + last.tMesh.crossings, first.tMesh.headOn + first.tMesh.crossings);
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
  EXPECT_TRUE(snap.singularities.empty());
  EXPECT_EQ(last, 1.0);
}
}
}
