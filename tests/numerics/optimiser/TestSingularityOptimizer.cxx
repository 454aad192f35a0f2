// The optimiser reaches minima, also with holonomy constraints and at all scales.

#include "SingularityOptimizer.h"

#include "BuiltinDomains.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "MinimumCheck.h"
#include "RenormalizedEnergy.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace crossfield::test
{
namespace
{
const Configuration Scattered = { { { 0.1, 0.2 }, 1, 0.0 }, { { -0.3, 0.5 }, 1, 0.0 },
  { { -0.5, -0.6 }, 1, 0.0 }, { { 0.3, 0.05 }, 1, 0.0 } };

OptimizerResult Optimize(const PlanarDomain& domain, const Configuration& start, double meshSize)
{
  OptimizerOptions options;
  options.meshSize = meshSize;
  return OptimizeSingularities(domain, start, options);
}

/// Expects that central differences of W agree with the gradient to a relative error of 1e-5, close
/// to the result, where the gradient is not zero.
void ExpectConsistentGradient(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize)
{
  DrillOptions options;
  options.meshSize = meshSize;
  const TriangleMesh mesh = DrillHoles(domain, {}, options);
  const PointPotential potential = PointPotentialOn(mesh, {}, TotalQuarters(configuration));
  Random random(11);
  Configuration near = configuration;
  for (Singularity& singularity : near)
  {
    singularity.position += 0.01 * Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
  }
  const auto energy = [&](const Configuration& at)
  { return EvaluateRenormalizedEnergy(potential, potential.Solve(at)); };
  const Eigen::Matrix2Xd gradient = energy(near).gradient;
  Eigen::Matrix2Xd differences(2, gradient.cols());
  const double step = 1e-5;
  for (Eigen::Index j = 0; j < gradient.cols(); ++j)
  {
    for (int axis = 0; axis < 2; ++axis)
    {
      Configuration moved = near;
      double& coordinate = moved[static_cast<std::size_t>(j)].position[axis];
      coordinate += step;
      const double above = energy(moved).energy;
      coordinate -= 2.0 * step;
      differences(axis, j) = (above - energy(moved).energy) / (2.0 * step);
    }
  }
  EXPECT_GT(gradient.norm(), 0.01);
  EXPECT_LT((differences - gradient).norm(), 1e-5 * gradient.norm());
}

void ExpectStationary(const OptimizerResult& result)
{
  EXPECT_TRUE(result.converged) << result.reason;
  ASSERT_FALSE(result.history.empty());
  EXPECT_LT(result.history.back().gradientNorm, 1e-6);
  EXPECT_LE(result.energyAfter, result.energyBefore);
  EXPECT_EQ(result.history.size(), static_cast<std::size_t>(result.iterations) + 1);
  for (double defect : result.holonomyDefect)
  {
    EXPECT_NEAR(defect, 0.0, 1e-6);
  }
}

void ExpectMinimum(const PlanarDomain& domain, const Configuration& configuration, double meshSize)
{
  const MinimumCheck check = CheckMinimum(domain, configuration, meshSize);
  EXPECT_GT(check.lowestEigenvalue, 0.0);
  EXPECT_LT(check.gain, 0.01); // the last mesh of the optimiser is finer around the singularities
}

TEST(SingularityOptimizer, ReachesExactMinimumOnDisk)
{
  const OptimizerResult result = Optimize(Builtin("disk", 0.04), Scattered, 0.04);
  ExpectStationary(result);
  // Energy of the circle; that of the polygon is lower by O(h²).
  EXPECT_NEAR(result.energyAfter, -7.2962, 0.02);
  std::vector<double> angles;
  for (const Singularity& singularity : result.configuration)
  {
    EXPECT_NEAR(singularity.position.norm(), std::pow(3.0 / 11.0, 0.125), 1e-3);
    angles.push_back(std::atan2(singularity.position.y(), singularity.position.x()));
  }
  std::sort(angles.begin(), angles.end());
  for (std::size_t i = 1; i < 4; ++i)
  {
    EXPECT_NEAR(angles[i] - angles[i - 1], 0.5 * Pi, 2e-3);
  }
}

TEST(SingularityOptimizer, ConvergesInValleyWithoutCurvature)
{
  // The curvature in the direction of rotations by differences is a rounding error here, and the
  // unbounded step would be 80 diagonals long.
  const PlanarDomain disk = { { RegularPolygon(314) } };
  Configuration start;
  for (const double angle : { 0.1, 1.5, 3.4, 4.9 })
  {
    start.push_back({ 0.4 * Point(std::cos(angle), std::sin(angle)), 1, 0.0 });
  }
  const OptimizerResult result = Optimize(disk, start, 0.02);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_NEAR(result.energyAfter, -7.2962, 0.003);
}

TEST(SingularityOptimizer, IsInvariantUnderSimilarities)
{
  const PlanarDomain disk = Builtin("disk", 0.1);
  const OptimizerResult plain = Optimize(disk, Scattered, 0.1);
  for (const double scale : { 1e-6, 1e6 })
  {
    const Similarity move{ 0.4, scale, scale * Point(1.0, -2.0) };
    const OptimizerResult result = Optimize(move(disk), move(Scattered), 0.1 * scale);
    EXPECT_TRUE(result.converged) << result.reason;
    EXPECT_NEAR(result.energyAfter - 4.0 * Pi * std::log(scale), plain.energyAfter, 0.02);
  }
}

TEST(SingularityOptimizer, IsInvariantUnderScalesOverHundredOrders)
{
  // The pair on the ring has a defect to remove. Scales are powers of two from 1e-59 to 1e59, so
  // that the meshes are the same.
  const Configuration pair = { { { 0.75, 0.05 }, 1, 0.0 }, { { -0.1, 0.65 }, -1, 0.0 } };
  for (const auto& [name, start, shift] :
    { std::tuple("disk", Scattered, 4.0 * Pi), std::tuple("ring", pair, 2.0 * Pi) })
  {
    const PlanarDomain domain = Builtin(name, 0.05);
    const OptimizerResult plain = Optimize(domain, start, 0.05);
    for (const int exponent : { -196, -133, -66, 66, 133, 196 })
    {
      SCOPED_TRACE(std::string(name) + " times 2 to the " + std::to_string(exponent));
      const double scale = std::ldexp(1.0, exponent);
      const Similarity move{ 0.0, scale, Point::Zero() };
      const OptimizerResult result = Optimize(move(domain), move(start), 0.05 * scale);
      EXPECT_TRUE(result.converged) << result.reason;
      EXPECT_EQ(result.iterations, plain.iterations);
      EXPECT_NEAR(result.energyBefore - shift * std::log(scale), plain.energyBefore, 1e-9);
      EXPECT_NEAR(result.energyAfter - shift * std::log(scale), plain.energyAfter, 1e-9);
      for (std::size_t i = 0; i < start.size(); ++i)
      {
        EXPECT_LT(
          (result.configuration[i].position / scale - plain.configuration[i].position).norm(),
          1e-8);
      }
    }
  }
}

TEST(SingularityOptimizer, ReachesMinimumOnEllipse)
{
  BuiltinDomain ellipse;
  ellipse.name = "ellipse";
  ellipse.width = 2.0;
  ellipse.height = 1.2;
  ellipse.edgeLength = 0.05;
  const PlanarDomain domain = MakePlanarDomain(MakeBuiltinDomain(ellipse));
  const OptimizerResult result = Optimize(domain,
    { { { 0.1, 0.2 }, 1, 0.0 }, { { -0.3, 0.3 }, 1, 0.0 }, { { -0.4, -0.2 }, 1, 0.0 },
      { { 0.3, 0.05 }, 1, 0.0 } },
    0.05);
  ExpectStationary(result);
  ExpectMinimum(domain, result.configuration, 0.05);
  ExpectConsistentGradient(domain, result.configuration, 0.05);
}

TEST(SingularityOptimizer, RemovesHolonomyDefectOfRing)
{
  const PlanarDomain ring = Builtin("ring", 0.05);
  const OptimizerResult pair =
    Optimize(ring, { { { 0.75, 0.05 }, 1, 0.0 }, { { -0.1, 0.65 }, -1, 0.0 } }, 0.05);
  ExpectStationary(pair);
  // Without a defect the two singularities are on one ray.
  EXPECT_NEAR(
    AngleBetween(pair.configuration[0].position, pair.configuration[1].position), 0.0, 0.02);
  ExpectConsistentGradient(ring, pair.configuration, 0.05);

  // Four singularities of either sign, as in the Ginzburg-Landau field.
  Configuration eight = OnCircle(4, 0.85, 0.25 * Pi, 1, 0.0);
  eight[3].position = 0.84 * Point(std::cos(-0.5), std::sin(-0.5));
  const Configuration inner = OnCircle(4, 0.5, 0.25 * Pi, -1, 0.0);
  eight.insert(eight.end(), inner.begin(), inner.end());
  const OptimizerResult result = Optimize(ring, eight, 0.05);
  ExpectStationary(result);
  for (std::size_t i = 1; i < 4; ++i)
  {
    EXPECT_NEAR(
      result.configuration[i].position.norm(), result.configuration[0].position.norm(), 2e-3);
  }
}

TEST(SingularityOptimizer, ReachesMinimumWithTwoIslands)
{
  const PlanarDomain domain = MakePlanarDomain(
    { Builtin("disk", 0.05).loops[0], { { 0.3, -0.1 }, { 0.5, -0.1 }, { 0.5, 0.1 }, { 0.3, 0.1 } },
      { { -0.5, -0.1 }, { -0.3, -0.1 }, { -0.3, 0.15 }, { -0.5, 0.15 } } });
  const OptimizerResult result = Optimize(domain, OnCircle(4, 0.7, 0.4, 1, 0.0), 0.05);
  ExpectStationary(result);
  ASSERT_EQ(result.holonomyDefect.size(), 2u);
  ExpectMinimum(domain, result.configuration, 0.05);
  ExpectConsistentGradient(domain, result.configuration, 0.05);
}

TEST(SingularityOptimizer, ReachesMinimumOnRoundedLShape)
{
  // With sharp corners no interior singularity is needed; with round ones four are.
  const double radius = 0.2;
  const auto round = [radius](const Point& centre, double from, double to)
  {
    Loop arc;
    for (int i = 0; i <= 16; ++i)
    {
      const double angle = from + (to - from) * i / 16.0;
      arc.push_back(centre + radius * Point(std::cos(angle), std::sin(angle)));
    }
    return arc;
  };
  Loop loop;
  const auto add = [&loop](const Loop& arc) { loop.insert(loop.end(), arc.begin(), arc.end()); };
  add(round({ radius, radius }, Pi, 1.5 * Pi));
  add(round({ 1.0 - radius, radius }, 1.5 * Pi, 2.0 * Pi));
  add(round({ 1.0 - radius, 0.5 - radius }, 0.0, 0.5 * Pi));
  add(round({ 0.5 + radius, 0.5 + radius }, 1.5 * Pi, Pi));
  add(round({ 0.5 - radius, 1.0 - radius }, 0.0, 0.5 * Pi));
  add(round({ radius, 1.0 - radius }, 0.5 * Pi, Pi));
  const PlanarDomain domain = MakePlanarDomain({ loop });
  const OptimizerResult result = Optimize(domain,
    { { { 0.2, 0.2 }, 1, 0.0 }, { { 0.7, 0.3 }, 1, 0.0 }, { { 0.35, 0.7 }, 1, 0.0 },
      { { 0.2, 0.6 }, 1, 0.0 } },
    0.02);
  ExpectStationary(result);
  ExpectMinimum(domain, result.configuration, 0.02);
  ExpectConsistentGradient(domain, result.configuration, 0.02);
}

TEST(SingularityOptimizer, GradientMatchesDifferencesForPair)
{
  const Configuration pair = { { { 0.3, 0.3 }, 1, 0.0 }, { { 0.7, 0.2 }, -1, 0.0 } };
  ExpectConsistentGradient(Builtin("l-shape"), pair, 0.04);
}

TEST(SingularityOptimizer, ReturnsBestConfigurationWhenAborted)
{
  OptimizerOptions options;
  options.meshSize = 0.1;
  const OptimizerResult complete = OptimizeSingularities(Builtin("disk", 0.1), Scattered, options);
  const Progress abort([](double fraction) { return fraction < 0.21; });
  const OptimizerResult result =
    OptimizeSingularities(Builtin("disk", 0.1), Scattered, options, abort);
  EXPECT_TRUE(result.aborted);
  EXPECT_FALSE(result.converged);
  EXPECT_GT(result.iterations, 0);
  EXPECT_LT(result.iterations, complete.iterations);
  EXPECT_LT(result.energyAfter, result.energyBefore);
}

TEST(SingularityOptimizer, ConvergesWithoutSingularities)
{
  const OptimizerResult result = Optimize(Builtin("square"), {}, 0.1);
  EXPECT_TRUE(result.converged);
  EXPECT_EQ(result.iterations, 0);
  EXPECT_NE(result.reason.find("There is no interior singularity"), std::string::npos);
}
}
}
