// J and its exact derivatives, and the optimiser that makes sizes uniform.

#include "SizeUniformity.h"

#include "BuiltinDomains.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "PositionCurvature.h"
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

/// Returns a domain with two islands, and with corners at which the potential has logarithms.
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

/// Expects that the gradient of J agrees with differences of its values.
void ExpectGradientOfJ(const PointPotential& potential, const SizeUniformity& uniformity,
  const Configuration& configuration)
{
  const auto value = [&](const Configuration& at)
  { return uniformity.Evaluate(potential, potential.Solve(at)); };
  const Eigen::VectorXd gradient = value(configuration).gradient;
  Eigen::VectorXd differences(gradient.size());
  const double step = 1e-5;
  for (Eigen::Index i = 0; i < gradient.size(); ++i)
  {
    Configuration moved = configuration;
    double& coordinate = moved[static_cast<std::size_t>(i / 2)].position[i % 2];
    coordinate += step;
    const double above = value(moved).energy;
    coordinate -= 2.0 * step;
    differences[i] = (above - value(moved).energy) / (2.0 * step);
  }
  EXPECT_GT(gradient.norm(), 1e-3);
  EXPECT_LT((differences - gradient).norm(), 1e-6 * gradient.norm());
}

/// Expects that the second derivatives of J agree with differences of its gradient.
void ExpectHessianOfJ(const std::shared_ptr<const PointPotential>& potential,
  const SizeUniformity& uniformity, const Configuration& configuration)
{
  const Eigen::MatrixXd regular =
    Differentiate(PositionEnergy(potential), configuration, Eigen::VectorXd()).regular;
  const Eigen::MatrixXd hessian =
    uniformity.Differentiate(*potential, potential->Solve(configuration), regular);
  Eigen::MatrixXd differences = Eigen::MatrixXd::Zero(hessian.rows(), hessian.cols());
  const double step = 1e-5;
  for (Eigen::Index i = 0; i < hessian.cols(); ++i)
  {
    for (const double sign : { 1.0, -1.0 })
    {
      Configuration moved = configuration;
      moved[static_cast<std::size_t>(i / 2)].position[i % 2] += sign * step;
      differences.col(i) +=
        sign / (2.0 * step) * uniformity.Evaluate(*potential, potential->Solve(moved)).gradient;
    }
  }
  EXPECT_GT(hessian.norm(), 1e-3);
  EXPECT_LT((differences - hessian).norm(), 1e-6 * hessian.norm());
}

/// Returns the mean of a function over the unit disk, by the midpoint rule on a polar grid.
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

TEST(SizeUniformity, MatchesExactSpreadOnDisk)
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

TEST(SizeUniformity, IsZeroForGrid)
{
  const PointPotential potential = PointPotentialOn(MeshOf(Builtin("l-shape"), 0.1), {}, 0);
  EXPECT_LT(UniformityOf(potential, {}).energy, 1e-20);
}

TEST(SizeUniformity, GradientMatchesDifferences)
{
  // One singularity is close to a vertex.
  const TriangleMesh mesh = MeshOf(Pentagon(), 0.1);
  const PointPotential potential = PointPotentialOn(mesh, {}, -5);
  Configuration configuration = AroundTheIslands();
  for (const Point& point : mesh.points)
  {
    if ((point - configuration[3].position).norm() < 0.06)
    {
      configuration[3].position = point + Point(1e-3, 2e-3);
    }
  }
  ExpectGradientOfJ(potential, SizeUniformity(potential), configuration);
  ExpectHessianOfJ(
    std::make_shared<const PointPotential>(potential), SizeUniformity(potential), configuration);
}

/// Four singularities of index 1 in the disk.
const Configuration Four = { { { 0.5, 0.1 }, 1, 0.0 }, { { -0.2, 0.6 }, 1, 0.0 },
  { { -0.6, -0.3 }, 1, 0.0 }, { { 0.3, -0.7 }, 1, 0.0 } };

/// Returns e^H of four singularities of index 1 in the disk, smoothed where it vanishes.
TargetSizes SizesOf(const Configuration& four)
{
  const auto size = [four](const Point& point)
  {
    constexpr double SquaredCore = 1e-4;
    const std::complex<double> z(point.x(), point.y());
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

/// Returns the maximum over one configuration of the distance to the nearest singularity of the
/// other.
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

TEST(SizeUniformity, ConstantTargetEqualsUniformSizes)
{
  const PointPotential potential = PointPotentialOn(MeshOf(Pentagon(), 0.1), {}, -5);
  const PointPotential::Solution solution = potential.Solve(AroundTheIslands());
  const SizeUniformity::Value uniform = SizeUniformity(potential).Evaluate(potential, solution);
  const SizeUniformity::Value constant = SizeUniformity(potential,
    { Sizing::Field,
      [](const Point&) { return 17.0; } }).Evaluate(potential, solution);
  EXPECT_NEAR(constant.energy, uniform.energy, 1e-13 * uniform.energy);
  EXPECT_LT((constant.gradient - uniform.gradient).norm(), 1e-12 * uniform.gradient.norm());
}

TEST(SizeUniformity, DoesNotDependOnUnitOfTargetSizes)
{
  const PointPotential potential = PointPotentialOn(MeshOf(Pentagon(), 0.1), {}, -5);
  const PointPotential::Solution solution = potential.Solve(AroundTheIslands());
  const auto evaluate = [&](double unit)
  {
    const auto target = [unit](const Point& x)
    { return unit * std::exp(0.5 * x.x() - x.y() * x.y()); };
    return SizeUniformity(potential, { Sizing::Field, target }).Evaluate(potential, solution);
  };
  const SizeUniformity::Value metres = evaluate(1.0);
  const SizeUniformity::Value millimetres = evaluate(1000.0);
  EXPECT_NEAR(millimetres.energy, metres.energy, 1e-12 * metres.energy);
  EXPECT_LT((millimetres.gradient - metres.gradient).norm(), 1e-11 * metres.gradient.norm());
}

TEST(SizeUniformity, GradientMatchesDifferencesWithTargetSizes)
{
  const PointPotential potential = PointPotentialOn(MeshOf(Pentagon(), 0.1), {}, -5);
  const SizeUniformity uniformity(potential,
    { Sizing::Field, [](const Point& x) { return 0.3 + std::exp(x.x() - 2.0 * x.y()); } });
  ExpectGradientOfJ(potential, uniformity, AroundTheIslands());
  ExpectHessianOfJ(
    std::make_shared<const PointPotential>(potential), uniformity, AroundTheIslands());
}

TEST(SizeUniformity, ConvergesToZeroForSizesOfField)
{
  // s = e^H, not e^{−H}: the spread tends to 0 with the mesh size, whereas the spread of uniform
  // sizes does not.
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

TEST(SizeUniformity, RejectsNonPositiveSizes)
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

TEST(SizeUniformity, OptimiserRecoversSingularitiesFromTargetSizes)
{
  // The four are not at the minimum of W, which the run reaches first and which is on another
  // circle.
  const PlanarDomain disk = Builtin("disk", 0.05);
  OptimizerOptions options;
  options.meshSize = 0.05;
  Configuration start = Four;
  Random random(3);
  for (Singularity& singularity : start)
  {
    singularity.position += 0.1 * Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
  }
  const OptimizerResult conformal = OptimizeSingularities(disk, start, options);
  EXPECT_FALSE(conformal.sizeSpreads);
  EXPECT_GT(LargestDistance(Four, conformal.configuration), 0.1);
  options.sizes = SizesOf(Four);
  const OptimizerResult result = OptimizeSingularities(disk, start, options);
  EXPECT_TRUE(result.converged) << result.reason;
  EXPECT_NE(result.reason.find("closest to the target sizes"), std::string::npos);
  EXPECT_LT(LargestDistance(Four, result.configuration), 0.01);
  ASSERT_TRUE(result.sizeSpreads);
  EXPECT_LT(result.sizeSpreads->after, 0.02);
  EXPECT_GT(result.sizeSpreads->before, 0.1);
}

TEST(SizeUniformity, OptimiserKeepsOnlySymmetriesOfTargetSizes)
{
  const PlanarDomain disk = MakePlanarDomain({ RegularPolygon(64, 1.0) });
  OptimizerOptions options;
  options.meshSize = 0.05;
  options.sizes = SizesOf(Four);
  const OptimizerResult none = OptimizeSingularities(disk, OnCircle(4, 0.6, 0.0, 1, 0.0), options);
  EXPECT_TRUE(none.converged) << none.reason;
  EXPECT_LT(LargestDistance(Four, none.configuration), 0.01);
  // These have both axes and the half turn as symmetries, but not the quarter turn.
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

TEST(SizeUniformity, OptimiserReducesSpreadAndConverges)
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
  const OptimizerResult conformal = OptimizeSingularities(domain, start, options);
  EXPECT_FALSE(conformal.sizeSpreads);
  options.sizes.sizing = Sizing::Uniform;
  const OptimizerResult uniform = OptimizeSingularities(domain, start, options);
  EXPECT_TRUE(uniform.converged) << uniform.reason;
  EXPECT_NE(uniform.reason.find("most uniform"), std::string::npos);
  ASSERT_TRUE(uniform.sizeSpreads);
  EXPECT_LT(uniform.sizeSpreads->after, uniform.sizeSpreads->before);
  EXPECT_GT(uniform.energyAfter, conformal.energyAfter);
  // W + 10,000 J is not lower at nearby configurations, on another mesh.
  const PointPotential potential = PointPotentialOn(MeshOf(domain, 0.03), {}, 4);
  const double reached = UniformityOf(potential, uniform.configuration).energy;
  EXPECT_NEAR(
    std::sqrt(2.0 * reached), uniform.sizeSpreads->after, 0.02 * uniform.sizeSpreads->after);
  EXPECT_LT(reached, UniformityOf(potential, conformal.configuration).energy);
  const auto goal = [&](const Configuration& at)
  {
    return EvaluateRenormalizedEnergy(potential, potential.Solve(at)).energy +
      1e4 * UniformityOf(potential, at).energy;
  };
  Random random(5);
  for (int attempt = 0; attempt < 5; ++attempt)
  {
    Configuration moved = uniform.configuration;
    for (Singularity& singularity : moved)
    {
      singularity.position += 0.05 * Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    }
    EXPECT_GT(goal(moved), goal(uniform.configuration));
  }
}
}
}
