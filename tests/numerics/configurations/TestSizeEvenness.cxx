// J, its exact derivatives, and the optimiser that makes sizes even.

#include "SizeEvenness.h"

#include "BuiltinDomains.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "RenormalizedEnergy.h"
#include "SingularityOptimizer.h"
#include "Support.h"

#include <cmath>
#include <complex>

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

SizeEvenness::Value EvennessOf(const PointPotential& potential, const Configuration& configuration)
{
  return SizeEvenness(potential).Evaluate(potential, potential.Solve(configuration));
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

TEST(SizeEvenness, IsThatOfTheExactHOnTheDisk)
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
    EvennessOf(potential, four).Spread(), std::sqrt(variance), 0.01 * std::sqrt(variance));
}

TEST(SizeEvenness, IsZeroWhereAGridFits)
{
  const PointPotential potential = PointPotentialOn(MeshOf(Builtin("l-shape"), 0.1), {}, 0);
  EXPECT_LT(EvennessOf(potential, {}).energy, 1e-20);
}

TEST(SizeEvenness, ItsGradientIsThatOfTheDiscreteJ)
{
  // With two islands, a corner that has a logarithm, and a singularity next to a vertex.
  const PlanarDomain domain = MakePlanarDomain({ RegularPolygon(5, 1.0),
    RegularPolygon(4, 0.15, { 0.3, -0.1 }), RegularPolygon(30, 0.15, { -0.3, 0.15 }) });
  const TriangleMesh mesh = MeshOf(domain, 0.1);
  const PointPotential potential = PointPotentialOn(mesh, {}, -5);
  Configuration around = { { { 0.55, 0.2 }, -1, 0.0 }, { { 0.05, 0.4 }, -2, 0.0 },
    { { -0.5, -0.2 }, -2, 0.0 }, { { 0.1, 0.05 }, 1, 0.0 }, { { 0.1, -0.5 }, -1, 0.0 } };
  for (const Point& point : mesh.points)
  {
    if ((point - around[3].position).norm() < 0.06)
    {
      around[3].position = point + Point(1e-3, 2e-3);
    }
  }
  const SizeEvenness evenness(potential);
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

TEST(SizeEvenness, TheOptimiserEndsAtLessSpreadAndAtRest)
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
  options.evenSizes = true;
  const OptimizerResult even = OptimizeSingularities(domain, start, options);
  EXPECT_TRUE(even.converged) << even.reason;
  EXPECT_NE(even.reason.find("most even"), std::string::npos);
  ASSERT_TRUE(even.sizeSpreads);
  EXPECT_LT(even.sizeSpreads->after, even.sizeSpreads->before);
  EXPECT_GT(even.energyAfter, least.energyAfter);
  // Nowhere nearby is W + 10,000 J less, on another mesh.
  const PointPotential potential = PointPotentialOn(MeshOf(domain, 0.03), {}, 4);
  const double reached = EvennessOf(potential, even.configuration).energy;
  EXPECT_NEAR(std::sqrt(2.0 * reached), even.sizeSpreads->after, 0.02 * even.sizeSpreads->after);
  EXPECT_LT(reached, EvennessOf(potential, least.configuration).energy);
  const auto goal = [&](const Configuration& at)
  {
    return EvaluateRenormalizedEnergy(potential, potential.Solve(at)).energy +
      1e4 * EvennessOf(potential, at).energy;
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
