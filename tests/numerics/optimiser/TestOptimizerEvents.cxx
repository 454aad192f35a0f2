// Changes that the optimiser makes besides moving singularities, and the sentences that report
// them.

#include "SingularityOptimizer.h"

#include "MakePlanarDomain.h"
#include "Support.h"

#include <algorithm>
#include <string>

namespace crossfield::test
{
namespace
{
TEST(OptimizerEvents, RemovesPairThatMeets)
{
  const PlanarDomain shape = Builtin("l-shape");
  const Configuration pair = { { { 0.3, 0.3 }, 1, 0.0 }, { { 0.7, 0.2 }, -1, 0.0 } };
  OptimizerOptions options;
  options.meshSize = 0.04;
  const OptimizerResult result = OptimizeSingularities(shape, pair, options);
  EXPECT_TRUE(result.converged) << result.reason;
  ASSERT_EQ(result.annihilations.size(), 1u);
  EXPECT_EQ(result.annihilations[0][0], 0);
  EXPECT_EQ(result.annihilations[0][1], 1);
  EXPECT_TRUE(result.configuration.empty());
  EXPECT_TRUE(
    AnyHas(result.events, "Singularity 1 and singularity 2, which have opposite signs, met at"));

  // With keepAll they remain at the clearance.
  options.keepAll = true;
  options.clearance = 0.02;
  const OptimizerResult kept = OptimizeSingularities(shape, pair, options);
  EXPECT_TRUE(kept.converged) << kept.reason;
  ASSERT_EQ(kept.configuration.size(), 2u);
  const double apart = (kept.configuration[0].position - kept.configuration[1].position).norm();
  EXPECT_GT(apart, 0.02);
  EXPECT_LT(apart, 1.25 * 0.02);
  EXPECT_LT(kept.energyAfter, kept.energyBefore);
  // The clearance keeps them from each other, so that they are not at a stationary point.
  EXPECT_NE(kept.reason.find("The clearance of 0.02 holds 2 singularities"), std::string::npos)
    << kept.reason;
}

TEST(OptimizerEvents, NeedsHolesForEventsAboutHolonomy)
{
  // The clearance pushes the pair apart, which raises the energy.
  OptimizerOptions options;
  options.keepAll = true;
  options.clearance = 0.02;
  const OptimizerResult result = OptimizeSingularities(
    Builtin("l-shape"), { { { 0.3, 0.3 }, 1, 0.0 }, { { 0.324, 0.3 }, -1, 0.0 } }, options);
  EXPECT_GT(result.energyAfter, result.energyBefore + 0.05);
  EXPECT_FALSE(AnyHas(result.events, "holonomy"));
}

TEST(OptimizerEvents, RoundingIsNoMove)
{
  // Singularities at the distance to which the clearance pushes them, up to rounding.
  OptimizerOptions options;
  options.clearance = 0.1;
  options.maximumIterations = 0;
  const PlanarDomain disk = Builtin("disk");
  Configuration start = OnCircle(4, 0.998, 0.3, 1, 0.0);
  const OptimizerResult pushed = OptimizeSingularities(disk, start, options);
  EXPECT_TRUE(AnyHas(pushed.events, "to keep the clearance at the start"));
  start = pushed.configuration;
  for (Singularity& singularity : start)
  {
    singularity.position *= 1.0 + 1e-14;
  }
  EXPECT_FALSE(AnyHas(OptimizeSingularities(disk, start, options).events, "was moved by"));
}

TEST(OptimizerEvents, EndsWithTheBestConfigurationWhenItsSolvesAreUsedUp)
{
  const PlanarDomain disk = Builtin("disk");
  const Configuration start = { { { 0.1, 0.1 }, 1, 0.0 }, { { -0.2, 0.1 }, 1, 0.0 },
    { { 0.0, -0.3 }, 1, 0.0 }, { { 0.4, -0.3 }, 1, 0.0 } };
  OptimizerOptions options;
  std::vector<double> energies;
  for (const std::size_t solves : { 25U, 30U, 0U })
  {
    options.maximumSolves = solves;
    const OptimizerResult result = OptimizeSingularities(disk, start, options);
    EXPECT_EQ(result.converged, solves == 0) << result.reason;
    EXPECT_EQ(result.reason.find("solves, its limit") != std::string::npos, solves > 0)
      << result.reason;
    // A step that has begun is completed: at most forty halvings.
    EXPECT_GE(result.solves, solves);
    EXPECT_TRUE(solves == 0 || result.solves <= solves + 40);
    energies.push_back(result.energyAfter);
    EXPECT_LT(result.energyAfter, result.energyBefore);
  }
  EXPECT_LT(energies[1], energies[0]);
  EXPECT_LT(energies[2], energies[1]);
}

TEST(OptimizerEvents, MergesOppositeSignsOfDifferentStrength)
{
  OptimizerOptions options;
  options.meshSize = 0.05;
  const OptimizerResult result = OptimizeSingularities(Builtin("disk", 0.05),
    { { { 0.5, 0.3 }, 2, 0.0 }, { { 0.55, 0.3 }, -1, 0.0 }, { { -0.6, 0.3 }, 1, 0.0 },
      { { 0.5, -0.5 }, 1, 0.0 }, { { -0.5, -0.5 }, 1, 0.0 } },
    options);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_TRUE(AnyHas(result.events, "were merged into one with quarter index 1"));
  ASSERT_EQ(result.configuration.size(), 4u);
  // The energy of four singularities at radius (3/11)^(1/8).
  EXPECT_NEAR(result.energyAfter, -7.2962, 0.02);
}

TEST(OptimizerEvents, CornerAbsorbsMissingQuarter)
{
  // The corner of natural index 1 is given the index 0 by a singularity on the boundary.
  const Configuration start = { { { 0.3, 0.3 }, 1, 0.0 }, { { 1.0, 0.0 }, 0, 0.0 } };
  OptimizerOptions options;
  options.meshSize = 0.04;
  const OptimizerResult result = OptimizeSingularities(Builtin("l-shape"), start, options);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_TRUE(AnyHas(result.events, "Singularity 1, quarter index 1, reached the boundary"));
  ASSERT_EQ(result.configuration.size(), 1u);
  EXPECT_EQ(result.configuration[0].position, Point(1.0, 0.0));
  EXPECT_EQ(result.configuration[0].quarterIndex, 1);
  EXPECT_NEAR(result.energyAfter, 0.0, 1e-9); // the cross is constant on an L with straight sides

  options.keepAll = true;
  const OptimizerResult kept = OptimizeSingularities(Builtin("l-shape"), start, options);
  EXPECT_TRUE(kept.converged) << kept.reason;
  ASSERT_EQ(kept.configuration.size(), 2u);
  const double clearance = Builtin("l-shape").Diagonal() / 400.0;
  EXPECT_LT((kept.configuration[0].position - Point(1.0, 0.0)).norm(), 3.0 * clearance);
  EXPECT_TRUE(AnyHas(kept.events, "The clearance stops singularity 1"));
  EXPECT_LT(kept.energyAfter, kept.energyBefore);
}

TEST(OptimizerEvents, BoundaryReleasesExcessQuarters)
{
  // All four quarters of the disk are at one point of the boundary.
  const PlanarDomain disk = Builtin("disk", 0.05);
  OptimizerOptions options;
  options.meshSize = 0.05;
  options.maximumIterations = 400;
  const OptimizerResult result =
    OptimizeSingularities(disk, { { disk.loops[0][0], 4, 0.0 } }, options);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_TRUE(AnyHas(result.events, "released a singularity with quarter index 1"));
  ASSERT_EQ(result.configuration.size(), 4u);
  // Energy of the circle; that of the polygon is lower by O(h²).
  EXPECT_NEAR(result.energyAfter, -7.2962, 0.02);
}

TEST(OptimizerEvents, ConvergesWithSingularitiesAtClearance)
{
  // The minimum of W for four singularities on a disk is at a distance of 0.15 from the boundary.
  OptimizerOptions options;
  options.meshSize = 0.05;
  options.clearance = 0.3;
  const OptimizerResult result =
    OptimizeSingularities(Builtin("disk", 0.05), OnCircle(4, 0.5, 0.3, 1, 0.0), options);
  EXPECT_TRUE(result.converged) << result.reason;
  ASSERT_EQ(result.configuration.size(), 4u);
  for (const Singularity& singularity : result.configuration)
  {
    EXPECT_NEAR(singularity.position.norm(), 0.7, 0.01);
  }
  EXPECT_TRUE(AnyHas(result.events, "The clearance stops singularity 4"));
}

TEST(OptimizerEvents, MovesStartAwayFromBoundary)
{
  OptimizerOptions options;
  options.meshSize = 0.05;
  Configuration start = OnCircle(4, 0.5, 0.3, 1, 0.0);
  start[2].position = 0.998 * start[2].position.normalized();
  const OptimizerResult result = OptimizeSingularities(Builtin("disk", 0.05), start, options);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_TRUE(AnyHas(result.events, "Singularity 3 at"));
  // Energy of the circle; that of the polygon is lower by O(h²).
  EXPECT_NEAR(result.energyAfter, -7.2962, 0.02);
}

TEST(OptimizerEvents, ReducesGivenRadiiToFit)
{
  OptimizerOptions options;
  options.meshSize = 0.05;
  const OptimizerResult result =
    OptimizeSingularities(Builtin("disk", 0.05), OnCircle(4, 0.5, 0.3, 1, 0.2), options);
  EXPECT_TRUE(AnyHas(result.events, "was reduced from 0.2 to"));
  for (const Singularity& singularity : result.configuration)
  {
    EXPECT_GT(singularity.radius, 0.04);
    EXPECT_LT(singularity.radius, 0.06); // a third of the distance 0.15
  }
  for (const Singularity& singularity :
    OptimizeSingularities(Builtin("disk", 0.05), OnCircle(4, 0.5, 0.3, 1, 0.0), options)
      .configuration)
  {
    EXPECT_EQ(singularity.radius, 0.0);
  }
}

TEST(OptimizerEvents, ReportsUnreachableDefect)
{
  // Two squares, the inner one rotated by 0.2: no singularities, and a defect of the phase.
  Loop hole = RegularPolygon(4, 0.2, { 0.5, 0.5 });
  for (Point& point : hole)
  {
    point = Similarity{ 0.25 * Pi + 0.2, 1.0, Point::Zero() }(Point(point - Point(0.5, 0.5))) +
      Point(0.5, 0.5);
  }
  const PlanarDomain domain = MakePlanarDomain({ Builtin("square").loops[0], hole });
  OptimizerOptions options;
  options.meshSize = 0.05;
  const OptimizerResult result = OptimizeSingularities(domain, {}, options);
  EXPECT_TRUE(result.converged);
  // 0.2 radians of the crosses; the mesh causes an error.
  EXPECT_TRUE(AnyHas(result.events, "A holonomy defect of 11.")) << result.events.back();
}

TEST(OptimizerEvents, KeepsSingularitiesOnBoundary)
{
  // A corner is given the index 0, and an interior singularity replaces its quarter.
  OptimizerOptions options;
  options.meshSize = 0.05;
  options.maximumIterations = 2;
  const Configuration start = { { { 0.0, 0.0 }, 0, 0.0 }, { { 0.6, 0.55 }, 1, 0.0 } };
  const OptimizerResult result = OptimizeSingularities(Builtin("square"), start, options);
  ASSERT_EQ(result.configuration.size(), 2u);
  EXPECT_EQ(result.configuration[0].position, start[0].position);
  EXPECT_NE(result.configuration[1].position, start[1].position);
}
}
}
