#include "ExactFields.h"
#include "MakePlanarDomain.h"
#include "MinimumCheck.h"
#include "SingularityOptimizer.h"
#include "Support.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
Eigen::VectorXd CoordinatesOf(const Configuration& configuration)
{
  Eigen::VectorXd coordinates(2 * static_cast<Eigen::Index>(configuration.size()));
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    coordinates.segment<2>(2 * static_cast<Eigen::Index>(i)) = configuration[i].position;
  }
  return coordinates;
}

/// Returns W of the image with the preimages of interior singularities at given positions.
double ExactEnergy(
  const DiskImage& image, Configuration preimages, const Eigen::VectorXd& coordinates)
{
  for (std::size_t i = 0; i < preimages.size(); ++i)
  {
    preimages[i].position = coordinates.segment<2>(2 * static_cast<Eigen::Index>(i));
    if (preimages[i].position.norm() > 0.999)
    {
      return std::numeric_limits<double>::infinity();
    }
  }
  return image.Energy(preimages);
}

TEST(OptimizerMinima, MatchExactEnergyOnDiskImages)
{
  const std::vector<Configuration> starts = { { { { 0.1, 0.2 }, 1, 0.0 }, { { -0.3, 0.5 }, 1, 0.0 },
                                                { { -0.5, -0.6 }, 1, 0.0 },
                                                { { 0.3, 0.05 }, 1, 0.0 } },
    { { { 0.4, 0.1 }, 2, 0.0 }, { { -0.3, 0.4 }, 1, 0.0 }, { { -0.2, -0.6 }, 1, 0.0 } } };
  for (const DiskImage& image : { DiskImage{ { 0.2, 0.1 }, 2 }, DiskImage{ { -0.1, 0.12 }, 3 } })
  {
    const double size = 0.04;
    const PlanarDomain domain =
      MakePlanarDomain({ image.Polygon(static_cast<int>(2.0 * Pi / size)) });
    for (const Configuration& start : starts)
    {
      OptimizerOptions options;
      options.meshSize = size;
      const OptimizerResult result = OptimizeSingularities(domain, image(start), options);
      EXPECT_TRUE(result.converged) << result.reason;
      ASSERT_EQ(result.configuration.size(), start.size());
      const auto energy = [&](const Eigen::VectorXd& coordinates)
      { return ExactEnergy(image, start, coordinates); };
      Configuration found = start;
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        const std::complex<double> z = image.Preimage(result.configuration[i].position);
        found[i].position = Point(z.real(), z.imag());
      }
      const Eigen::VectorXd coordinates = CoordinatesOf(found);
      // A minimum of the exact W is nearby, and descending the exact W from the start reaches none
      // below it.
      const Eigen::VectorXd minimum = Minimise(energy, coordinates);
      const Derivatives derivatives = Differentiate(energy, minimum, 1e-4);
      EXPECT_GT(
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(derivatives.hessian).eigenvalues()[0], 0.1);
      EXPECT_LT(derivatives.gradient.norm(), 1e-3);
      EXPECT_LT((coordinates - minimum).cwiseAbs().maxCoeff(), 0.01);
      EXPECT_LT(energy(coordinates) - energy(minimum), 5e-3);
      EXPECT_NEAR(result.energyAfter, energy(minimum), 0.05);
      EXPECT_LT(energy(coordinates), energy(Minimise(energy, CoordinatesOf(start))) + 5e-3);
    }
  }
}

/// Returns three to five singularities with sum 4, with preimages at least 0.1 apart and up to 0.01
/// close to the circle.
Configuration RandomPreimages(Random& random)
{
  const std::vector<std::vector<int>> quarters = { { 1, 1, 1, 1 }, { 2, 1, 1 }, { 3, 2, -1 },
    { 1, 1, 1, 2, -1 }, { 2, 2, 1, -1 } };
  const auto last = static_cast<int>(quarters.size()) - 1;
  Configuration preimages;
  for (const int quarter : quarters[static_cast<std::size_t>(random.Integer(0, last))])
  {
    Point position;
    do
    {
      const Complex z = std::sqrt(random.Uniform(0.0, 0.98)) * random.UnitComplex();
      position = Point(z.real(), z.imag());
    } while (std::any_of(preimages.begin(), preimages.end(),
      [&](const Singularity& other) { return (other.position - position).norm() < 0.1; }));
    preimages.push_back({ position, quarter, 0.0 });
  }
  return preimages;
}

TEST(OptimizerMinima, SmoothBoundaryNeitherAbsorbsNorStops)
{
  // W of docs/method.md §5.3 contains −πk² log(1 − |b|²): a smooth boundary repels every
  // singularity, whatever its sign.
  const double size = 0.06;
  const DiskImage image{ { 0.2, 0.1 }, 2 };
  const PlanarDomain domain =
    MakePlanarDomain({ image.Polygon(static_cast<int>(2.0 * Pi / size)) });
  OptimizerOptions options;
  options.meshSize = size;
  Random random(17);
  for (int trial = 0; trial < 16; ++trial)
  {
    const Configuration start = RandomPreimages(random);
    SCOPED_TRACE("trial " + std::to_string(trial));
    const OptimizerResult result = OptimizeSingularities(domain, image(start), options);
    EXPECT_TRUE(result.converged) << result.reason;
    for (const std::string& event : result.events)
    {
      EXPECT_EQ(event.find("reached the boundary"), std::string::npos) << event;
      EXPECT_EQ(event.find("clearance stops"), std::string::npos) << event;
    }
    EXPECT_EQ(TotalQuarters(result.configuration), 4);
    Configuration found = result.configuration;
    for (Singularity& singularity : found)
    {
      const std::complex<double> z = image.Preimage(singularity.position);
      singularity.position = Point(z.real(), z.imag());
      EXPECT_GT(singularity.quarterIndex, 0); // opposite signs attract each other and are merged
    }
    const auto energy = [&](const Eigen::VectorXd& coordinates)
    { return ExactEnergy(image, found, coordinates); };
    const Eigen::VectorXd coordinates = CoordinatesOf(found);
    const Eigen::VectorXd minimum = Minimise(energy, coordinates);
    EXPECT_GT(
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Differentiate(energy, minimum, 1e-4).hessian)
        .eigenvalues()[0],
      0.1);
    EXPECT_LT((coordinates - minimum).cwiseAbs().maxCoeff(), 0.02);
    EXPECT_NEAR(result.energyAfter, energy(minimum), 0.1);
  }
}

/// Returns the configuration at polar coordinates on the ring. The last angle follows from the
/// others, so that there is no holonomy defect; the quarter index of the last singularity is −1.
Configuration WithoutDefect(Configuration configuration, const Eigen::VectorXd& polar)
{
  double turns = 0.0;
  const std::size_t last = configuration.size() - 1;
  for (std::size_t i = 0; i <= last; ++i)
  {
    const auto row = static_cast<Eigen::Index>(2 * i);
    const double angle = i < last ? polar[row + 1] : turns;
    turns += configuration[i].quarterIndex * angle;
    configuration[i].position = polar[row] * Point(std::cos(angle), std::sin(angle));
  }
  return configuration;
}

TEST(OptimizerMinima, MatchExactConstrainedEnergyOnRing)
{
  const ExactRing ring;
  Configuration eight = OnCircle(4, 0.85, 0.25 * Pi, 1, 0.0);
  const Configuration inner = OnCircle(4, 0.5, 0.25 * Pi, -1, 0.0);
  eight.insert(eight.end(), inner.begin(), inner.end());
  eight[1].position = { -0.55, 0.65 };
  for (const Configuration& start :
    { Configuration{ { { 0.75, 0.05 }, 1, 0.0 }, { { -0.1, 0.65 }, -1, 0.0 } }, eight })
  {
    OptimizerOptions options;
    options.meshSize = 0.03;
    const OptimizerResult result = OptimizeSingularities(Builtin("ring", 0.03), start, options);
    EXPECT_TRUE(result.converged) << result.reason;
    ASSERT_EQ(result.configuration.size(), start.size());
    Eigen::VectorXd polar(2 * static_cast<Eigen::Index>(start.size()) - 1);
    for (std::size_t i = 0; i < start.size(); ++i)
    {
      const Point& position = result.configuration[i].position;
      polar[static_cast<Eigen::Index>(2 * i)] = position.norm();
      if (i + 1 < start.size())
      {
        polar[static_cast<Eigen::Index>(2 * i + 1)] = std::atan2(position.y(), position.x());
      }
    }
    const auto energy = [&](const Eigen::VectorXd& at)
    {
      const Configuration moved = WithoutDefect(start, at);
      const bool inside = std::all_of(moved.begin(), moved.end(),
        [&](const Singularity& s)
        { return s.position.norm() > ring.inner && s.position.norm() < 1.0; });
      return inside ? ring.SingleValuedEnergy(moved) : std::numeric_limits<double>::infinity();
    };
    EXPECT_NEAR(ring.Defect(result.configuration), 0.0, 2e-3);
    const Configuration minimum = WithoutDefect(start, Minimise(energy, polar));
    for (std::size_t i = 0; i < start.size(); ++i)
    {
      EXPECT_NEAR(result.configuration[i].position.norm(), minimum[i].position.norm(), 3e-3);
    }
    EXPECT_NEAR(result.energyAfter, ring.SingleValuedEnergy(minimum), 0.1);
  }
}

TEST(OptimizerMinima, SaddleHasNegativeEigenvalue)
{
  // Four singularities in a row repel each other off the axis.
  const Configuration row = { { { -0.8, 0.0 }, 1, 0.0 }, { { -0.3, 0.0 }, 1, 0.0 },
    { { 0.3, 0.0 }, 1, 0.0 }, { { 0.8, 0.0 }, 1, 0.0 } };
  EXPECT_LT(CheckMinimum(Builtin("disk", 0.1), row, 0.1).lowestEigenvalue, -1.0);
}
}
}
