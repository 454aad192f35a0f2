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
Eigen::VectorXd PlacesOf(const Configuration& configuration)
{
  Eigen::VectorXd places(2 * static_cast<Eigen::Index>(configuration.size()));
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    places.segment<2>(2 * static_cast<Eigen::Index>(i)) = configuration[i].position;
  }
  return places;
}

/// W of the image, with the preimages of singularities inside at these places.
double ExactEnergy(const DiskImage& image, Configuration preimages, const Eigen::VectorXd& places)
{
  for (std::size_t i = 0; i < preimages.size(); ++i)
  {
    preimages[i].position = places.segment<2>(2 * static_cast<Eigen::Index>(i));
    if (preimages[i].position.norm() > 0.999)
    {
      return std::numeric_limits<double>::infinity();
    }
  }
  return image.Energy(preimages);
}

TEST(OptimizerMinima, OnDiskImagesTheyAreThoseOfTheExactEnergy)
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
      const auto energy = [&](const Eigen::VectorXd& places)
      { return ExactEnergy(image, start, places); };
      Configuration found = start;
      for (std::size_t i = 0; i < found.size(); ++i)
      {
        const std::complex<double> z = image.Preimage(result.configuration[i].position);
        found[i].position = Point(z.real(), z.imag());
      }
      const Eigen::VectorXd places = PlacesOf(found);
      // A minimum of the exact W is near, and none below it is on the way from the start.
      const Eigen::VectorXd least = Minimise(energy, places);
      const Derivatives there = Differentiate(energy, least, 1e-4);
      EXPECT_GT(
        Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(there.hessian).eigenvalues()[0], 0.1);
      EXPECT_LT(there.gradient.norm(), 1e-3);
      EXPECT_LT((places - least).cwiseAbs().maxCoeff(), 0.01);
      EXPECT_LT(energy(places) - energy(least), 5e-3);
      EXPECT_NEAR(result.energyAfter, energy(least), 0.05);
      EXPECT_LT(energy(places), energy(Minimise(energy, PlacesOf(start))) + 5e-3);
    }
  }
}

/// Three to five singularities of sum 4, their preimages at least 0.1 apart, as near to the circle as 0.01.
Configuration RandomPreimages(Random& random)
{
  const std::vector<std::vector<int>> quarters = { { 1, 1, 1, 1 }, { 2, 1, 1 }, { 3, 2, -1 },
    { 1, 1, 1, 2, -1 }, { 2, 2, 1, -1 } };
  const auto last = static_cast<int>(quarters.size()) - 1;
  Configuration preimages;
  for (const int quarter : quarters[static_cast<std::size_t>(random.Integer(0, last))])
  {
    Point place;
    do
    {
      const Complex z = std::sqrt(random.Uniform(0.0, 0.98)) * random.UnitComplex();
      place = Point(z.real(), z.imag());
    } while (std::any_of(preimages.begin(), preimages.end(),
      [&](const Singularity& other) { return (other.position - place).norm() < 0.1; }));
    preimages.push_back({ place, quarter, 0.0 });
  }
  return preimages;
}

TEST(OptimizerMinima, TheBoundaryOfADiskImageTakesAndHoldsNone)
{
  // W of docs/method.md §5.3 has −πk² log(1 − |b|²): at a curve it repels every singularity, whatever its sign.
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
      EXPECT_EQ(event.find("pressed"), std::string::npos) << event;
      EXPECT_EQ(event.find("clearance holds"), std::string::npos) << event;
    }
    EXPECT_EQ(TotalQuarters(result.configuration), 4);
    Configuration found = result.configuration;
    for (Singularity& singularity : found)
    {
      const std::complex<double> z = image.Preimage(singularity.position);
      singularity.position = Point(z.real(), z.imag());
      EXPECT_GT(singularity.quarterIndex, 0); // unlike signs attract
    }
    const auto energy = [&](const Eigen::VectorXd& places)
    { return ExactEnergy(image, found, places); };
    const Eigen::VectorXd places = PlacesOf(found);
    const Eigen::VectorXd least = Minimise(energy, places);
    EXPECT_GT(
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(Differentiate(energy, least, 1e-4).hessian)
        .eigenvalues()[0],
      0.1);
    EXPECT_LT((places - least).cwiseAbs().maxCoeff(), 0.02);
    EXPECT_NEAR(result.energyAfter, energy(least), 0.1);
  }
}

/// The configuration at places of the ring in polar coordinates, the last angle of which follows from the others: no
/// holonomy defect. Its quarter index is −1.
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

TEST(OptimizerMinima, OnARingTheyAreThoseOfTheExactEnergyAmongFieldsWithoutDefect)
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
      const Point& place = result.configuration[i].position;
      polar[static_cast<Eigen::Index>(2 * i)] = place.norm();
      if (i + 1 < start.size())
      {
        polar[static_cast<Eigen::Index>(2 * i + 1)] = std::atan2(place.y(), place.x());
      }
    }
    const auto energy = [&](const Eigen::VectorXd& at)
    {
      const Configuration there = WithoutDefect(start, at);
      const bool inside = std::all_of(there.begin(), there.end(),
        [&](const Singularity& s)
        { return s.position.norm() > ring.inner && s.position.norm() < 1.0; });
      return inside ? ring.SingleValuedEnergy(there) : std::numeric_limits<double>::infinity();
    };
    EXPECT_NEAR(ring.Defect(result.configuration), 0.0, 2e-3);
    const Configuration least = WithoutDefect(start, Minimise(energy, polar));
    for (std::size_t i = 0; i < start.size(); ++i)
    {
      EXPECT_NEAR(result.configuration[i].position.norm(), least[i].position.norm(), 3e-3);
    }
    EXPECT_NEAR(result.energyAfter, ring.SingleValuedEnergy(least), 0.1);
  }
}

TEST(OptimizerMinima, ASaddleIsNone)
{
  // Four in a row are pushed off it by each other.
  const Configuration row = { { { -0.8, 0.0 }, 1, 0.0 }, { { -0.3, 0.0 }, 1, 0.0 },
    { { 0.3, 0.0 }, 1, 0.0 }, { { 0.8, 0.0 }, 1, 0.0 } };
  EXPECT_LT(CheckMinimum(Builtin("disk", 0.1), row, 0.1).lowestEigenvalue, -1.0);
}
}
}
