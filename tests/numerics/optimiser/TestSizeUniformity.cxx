// J, its exact derivatives, and the optimiser that makes sizes even.

#include "SizeUniformity.h"

#include "BuiltinDomains.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "RenormalizedEnergy.h"
#include "SingularityOptimizer.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <vector>

namespace crossfield::test
{
namespace
{
TriangleMesh MeshOf(const PlanarDomain& domain, double size)
{
  DrillOptions options;
  options.meshSize = size;
  return DrillHoles(domain, {}, options);
}

SizeUniformity::Value UniformityOf(
  const PointPotential& potential, const Configuration& configuration)
{
  return SizeUniformity(potential).Evaluate(potential, potential.Solve(configuration));
}

/// With two islands and a corner that has a logarithm.
PlanarDomain Pentagon()
{
  return MakePlanarDomain({ RegularPolygon(5, 1.0), RegularPolygon(4, 0.15, { 0.3, -0.1 }),
    RegularPolygon(30, 0.15, { -0.3, 0.15 }) });
}

Configuration AroundTheIslands()
{
  return { { { 0.55, 0.2 }, -1, 0.0 }, { { 0.05, 0.4 }, -2, 0.0 }, { { -0.5, -0.2 }, -2, 0.0 },
    { { 0.1, 0.05 }, 1, 0.0 }, { { 0.1, -0.5 }, -1, 0.0 } };
}

/// The gradient of J is that of its values.
void ExpectGradientOfJ(
  const PointPotential& potential, const SizeUniformity& evenness, const Configuration& around)
{
  const auto value = [&](const Configuration& at)
  { return evenness.Evaluate(potential, potential.Solve(at)); };
  const Eigen::VectorXd gradient = value(around).gradient;
  Eigen::VectorXd differences(gradient.size());
  const double step = 1e-5;
  for (Eigen::Index i = 0; i < gradient.size(); ++i)
  {
    Configuration moved = around;
    double& coordinate = moved[static_cast<std::size_t>(i / 2)].position[i % 2];
    coordinate += step;
    const double above = value(moved).energy;
    coordinate -= 2.0 * step;
    differences[i] = (above - value(moved).energy) / (2.0 * step);
  }
  EXPECT_GT(gradient.norm(), 1e-3);
  EXPECT_LT((differences - gradient).norm(), 1e-6 * gradient.norm());
}

/// The mean over the unit disk of a function on a polar grid, by midpoints.
template <class F>
double DiskMean(const F& f)
{
  constexpr int Rings = 400;
  constexpr int Angles = 400;
  double sum = 0.0;
  for (int i = 0; i < Rings; ++i)
  {
    const double radius = (i + 0.5) / Rings;
    for (int j = 0; j < Angles; ++j)
    {
      const double angle = 2.0 * Pi * (j + 0.5) / Angles;
      sum += radius * f(std::polar(radius, angle));
    }
  }
  return 2.0 * sum / (static_cast<double>(Rings) * Angles);
}

TEST(SizeUniformity, IsThatOfTheExactHOnTheDisk)
{
  const Configuration four = { { { 0.6, 0.1 }, 1, 0.0 }, { { -0.2, 0.5 }, 1, 0.0 },
    { { -0.5, -0.3 }, 1, 0.0 }, { { 0.3, -0.6 }, 1, 0.0 } };
  const auto h = [&four](const std::complex<double>& z)
  {
    double sum = 0.0;
    for (const Singularity& singularity : four)
    {
      const std::complex<double> b(singularity.position.x(), singularity.position.y());
      sum += 0.25 * std::log(std::abs(z - b) * std::abs(1.0 - std::conj(b) * z));
    }
    return sum;
  };
  const double mean = DiskMean(h);
  const double variance = DiskMean([&](const auto& z) { return std::pow(h(z) - mean, 2); });
  const PlanarDomain disk = Builtin("disk", 0.05);
  const PointPotential potential = PointPotentialOn(MeshOf(disk, 0.05), {}, 4);
  EXPECT_NEAR(
    UniformityOf(potential, four).Spread(), std::sqrt(variance), 0.01 * std::sqrt(variance));
}

TEST(SizeUniformity, IsZeroWhereAGridFits)
{
  const PointPotential potential = PointPotentialOn(MeshOf(Builtin("l-shape"), 0.1), {}, 0);
  EXPECT_LT(UniformityOf(potential, {}).energy, 1e-20);
}

TEST(SizeUniformity, ItsGradientIsThatOfTheDiscreteJ)
{
  // One of the singularities next to a vertex.
  const TriangleMesh mesh = MeshOf(Pentagon(), 0.1);
  const PointPotential potential = PointPotentialOn(mesh, {}, -5);
  Configuration around = AroundTheIslands();
  for (const Point& point : mesh.points)
  {
    if ((point - around[3].position).norm() < 0.06)
    {
      around[3].position = point + Point(1e-3, 2e-3);
    }
  }
  ExpectGradientOfJ(potential, SizeUniformity(potential), around);
}

/// Four of index 1 in the disk.
const Configuration Four = { { { 0.5, 0.1 }, 1, 0.0 }, { { -0.2, 0.6 }, 1, 0.0 },
  { { -0.6, -0.3 }, 1, 0.0 }, { { 0.3, -0.7 }, 1, 0.0 } };

/// Returns e^H of four singularities of index 1 in the disk, smoothed where it vanishes.
TargetSizes SizesOf(const Configuration& four)
{
  const auto size = [four](const Point& place)
  {
    constexpr double SquaredCore = 1e-4;
    const std::complex<double> z(place.x(), place.y());
    double h = 0.0;
    for (const Singularity& singularity : four)
    {
      const std::complex<double> b(singularity.position.x(), singularity.position.y());
      h += 0.125 * std::log((std::norm(z - b) + SquaredCore) * std::norm(1.0 - std::conj(b) * z));
    }
    return std::exp(h);
  };
  return { Sizing::Field, size };
}

/// Of each place in the configuration from the nearest of the other, the largest.
double LargestDistance(const Configuration& one, const Configuration& other)
{
  double largest = 0.0;
  for (const Singularity& singularity : one)
  {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Singularity& image : other)
    {
      nearest = std::min(nearest, (image.position - singularity.position).norm());
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

TEST(SizeUniformity, ToAConstantSizeIsThatOfEvenSizes)
{
  const PointPotential potential = PointPotentialOn(MeshOf(Pentagon(), 0.1), {}, -5);
  const PointPotential::Solution solution = potential.Solve(AroundTheIslands());
  const SizeUniformity::Value even = SizeUniformity(potential).Evaluate(potential, solution);
  const SizeUniformity::Value constant = SizeUniformity(potential,
    { Sizing::Field,
      [](const Point&) { return 17.0; } }).Evaluate(potential, solution);
  EXPECT_NEAR(constant.energy, even.energy, 1e-13 * even.energy);
  EXPECT_LT((constant.gradient - even.gradient).norm(), 1e-12 * even.gradient.norm());
}

TEST(SizeUniformity, DoesNotDependOnTheUnitOfWantedSizes)
{
  const PointPotential potential = PointPotentialOn(MeshOf(Pentagon(), 0.1), {}, -5);
  const PointPotential::Solution solution = potential.Solve(AroundTheIslands());
  const auto evaluate = [&](double unit)
  {
    const auto wanted = [unit](const Point& x)
    { return unit * std::exp(0.5 * x.x() - x.y() * x.y()); };
    return SizeUniformity(potential, { Sizing::Field, wanted }).Evaluate(potential, solution);
  };
  const SizeUniformity::Value metres = evaluate(1.0);
  const SizeUniformity::Value millimetres = evaluate(1000.0);
  EXPECT_NEAR(millimetres.energy, metres.energy, 1e-12 * metres.energy);
  EXPECT_LT((millimetres.gradient - metres.gradient).norm(), 1e-11 * metres.gradient.norm());
}

TEST(SizeUniformity, ItsGradientIsThatOfTheDiscreteJOfWantedSizes)
{
  const PointPotential potential = PointPotentialOn(MeshOf(Pentagon(), 0.1), {}, -5);
  const SizeUniformity evenness(potential,
    { Sizing::Field, [](const Point& x) { return 0.3 + std::exp(x.x() - 2.0 * x.y()); } });
  ExpectGradientOfJ(potential, evenness, AroundTheIslands());
}

TEST(SizeUniformity, IsZeroWhereTheSizesOfTheFieldAreWanted)
{
  // s = e^H, not e^{-H}: J falls with the mesh size to 0, and the spread of uniform sizes does not.
  std::vector<double> spreads;
  for (const double size : { 0.08, 0.04 })
  {
    const PointPotential potential = PointPotentialOn(MeshOf(Builtin("disk", size), size), {}, 4);
    spreads.push_back(
      SizeUniformity(potential, SizesOf(Four)).Evaluate(potential, potential.Solve(Four)).Spread());
  }
  EXPECT_LT(spreads[0], 0.03);
  EXPECT_LT(spreads[1], 0.6 * spreads[0]);
  const PointPotential potential = PointPotentialOn(MeshOf(Builtin("disk", 0.08), 0.08), {}, 4);
  EXPECT_GT(UniformityOf(potential, Four).Spread(), 0.1);
}

TEST(SizeUniformity, RefusesASizeThatIsNotPositive)
{
  const PointPotential potential = PointPotentialOn(MeshOf(Builtin("l-shape"), 0.2), {}, 0);
  for (const double size : { 0.0, -1.0, std::numeric_limits<double>::quiet_NaN(),
         std::numeric_limits<double>::infinity() })
  {
    EXPECT_TRUE(Refuses(
      [&] {
        SizeUniformity(potential, { Sizing::Field, [size](const Point&) { return size; } });
      },
      { "The target size at", "not a positive number" }));
  }
}

TEST(SizeUniformity, TheOptimiserFindsTheSingularitiesThatHaveTheWantedSizes)
{
  // The four are at no minimum of W; those of that, where the run is first, are on another circle.
  const PlanarDomain disk = Builtin("disk", 0.05);
  OptimizerOptions options;
  options.meshSize = 0.05;
  Configuration start = Four;
  Random random(3);
  for (Singularity& singularity : start)
  {
    singularity.position += 0.1 * Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
  }
  const OptimizerResult least = OptimizeSingularities(disk, start, options);
  EXPECT_FALSE(least.sizeSpreads);
  EXPECT_GT(LargestDistance(Four, least.configuration), 0.1);
  options.sizes = SizesOf(Four);
  const OptimizerResult result = OptimizeSingularities(disk, start, options);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_NE(result.reason.find("nearest to the target sizes"), std::string::npos);
  EXPECT_LT(LargestDistance(Four, result.configuration), 0.01);
  ASSERT_TRUE(result.sizeSpreads);
  EXPECT_LT(result.sizeSpreads->after, 0.02);
  EXPECT_GT(result.sizeSpreads->before, 0.1);
}

TEST(SizeUniformity, SymmetriesOfTheDomainThatWantedSizesHaveNotAreNotKept)
{
  const PlanarDomain disk = MakePlanarDomain({ RegularPolygon(64, 1.0) });
  OptimizerOptions options;
  options.meshSize = 0.05;
  options.sizes = SizesOf(Four);
  const OptimizerResult none = OptimizeSingularities(disk, OnCircle(4, 0.6, 0.0, 1, 0.0), options);
  EXPECT_TRUE(none.converged) << none.reason;
  EXPECT_LT(LargestDistance(Four, none.configuration), 0.01);
  // These have both axes and the half turn, but not the quarter turn.
  const Configuration rectangle = { { { 0.7, 0.4 }, 1, 0.0 }, { { -0.7, 0.4 }, 1, 0.0 },
    { { -0.7, -0.4 }, 1, 0.0 }, { { 0.7, -0.4 }, 1, 0.0 } };
  options.sizes = SizesOf(rectangle);
  const OptimizerResult half =
    OptimizeSingularities(disk, OnCircle(4, 0.6, 0.25 * Pi, 1, 0.0), options);
  EXPECT_TRUE(half.converged) << half.reason;
  EXPECT_LT(LargestDistance(rectangle, half.configuration), 0.01);
  const Point first = half.configuration[0].position.cwiseAbs();
  for (const Singularity& singularity : half.configuration)
  {
    EXPECT_LT((singularity.position.cwiseAbs() - first).norm(), 1e-9);
  }
}

TEST(SizeUniformity, TheOptimiserEndsAtLessSpreadAndAtRest)
{
  OptimizerOptions options;
  BuiltinDomain ellipse;
  ellipse.name = "ellipse";
  ellipse.width = 2.0;
  ellipse.height = 1.2;
  ellipse.edgeLength = 0.05;
  const PlanarDomain domain = MakePlanarDomain(MakeBuiltinDomain(ellipse));
  options.meshSize = 0.05;
  const Configuration start = { { { 0.1, 0.2 }, 1, 0.0 }, { { -0.3, 0.3 }, 1, 0.0 },
    { { -0.4, -0.2 }, 1, 0.0 }, { { 0.3, 0.05 }, 1, 0.0 } };
  const OptimizerResult least = OptimizeSingularities(domain, start, options);
  EXPECT_FALSE(least.sizeSpreads);
  options.sizes.sizing = Sizing::Uniform;
  const OptimizerResult even = OptimizeSingularities(domain, start, options);
  EXPECT_TRUE(even.converged) << even.reason;
  EXPECT_NE(even.reason.find("most even"), std::string::npos);
  ASSERT_TRUE(even.sizeSpreads);
  EXPECT_LT(even.sizeSpreads->after, even.sizeSpreads->before);
  EXPECT_GT(even.energyAfter, least.energyAfter);
  // Nowhere nearby is W + 10,000 J less, on another mesh.
  const PointPotential potential = PointPotentialOn(MeshOf(domain, 0.03), {}, 4);
  const double reached = UniformityOf(potential, even.configuration).energy;
  EXPECT_NEAR(std::sqrt(2.0 * reached), even.sizeSpreads->after, 0.02 * even.sizeSpreads->after);
  EXPECT_LT(reached, UniformityOf(potential, least.configuration).energy);
  const auto goal = [&](const Configuration& at)
  {
    return EvaluateRenormalizedEnergy(potential, potential.Solve(at)).energy +
      1e4 * UniformityOf(potential, at).energy;
  };
  Random random(5);
  for (int attempt = 0; attempt < 5; ++attempt)
  {
    Configuration moved = even.configuration;
    for (Singularity& singularity : moved)
    {
      singularity.position += 0.05 * Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    }
    EXPECT_GT(goal(moved), goal(even.configuration));
  }
}
}
}
