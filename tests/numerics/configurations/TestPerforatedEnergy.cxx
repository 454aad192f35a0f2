#include "MakePlanarDomain.h"
#include "PerforatedEnergy.h"

#include "ConfigurationEnergy.h"
#include "DrillHoles.h"
#include "Support.h"
#include "UnitNormField.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
PerforatedEnergy Compute(
  const PlanarDomain& domain, const Configuration& holes, double meshSize, int holeEdges = 32)
{
  DrillOptions options;
  options.meshSize = meshSize;
  options.minimumHoleEdges = holeEdges;
  // With a fixed growth the triangles around a hole would not all become smaller.
  options.gradation = 2.5 * meshSize;
  return ComputePerforatedEnergy(ShareTopology(DrillHoles(domain, holes, options)));
}

/// Expects that the exact energy is between the bounds on every mesh, and that these close in at
/// second order.
void ExpectBracket(const std::function<std::array<double, 2>(double)>& bounds, double exact)
{
  std::vector<double> sizes;
  std::vector<double> gaps;
  for (const double size : { 0.1, 0.05, 0.025, 0.0125 })
  {
    SCOPED_TRACE(size);
    const auto [lower, upper] = bounds(size);
    EXPECT_LE(lower, exact * (1.0 + 1e-12));
    EXPECT_GE(upper, exact * (1.0 - 1e-12));
    sizes.push_back(size);
    gaps.push_back(upper - lower);
  }
  EXPECT_GE(ConvergenceRate(sizes, gaps), 1.7);
  EXPECT_LT(gaps.back(), 2e-3 * exact);
}

TEST(PerforatedEnergy, BoundsOfACentredHole)
{
  const double exact = 16.0 * Pi * std::log(1.0 / 0.3);
  const auto compute = [](double size)
  {
    return Compute(Builtin("disk", size), { { { 0.0, 0.0 }, 4, 0.3 } }, size,
      static_cast<int>(2.0 * Pi * 0.3 / size) + 8);
  };
  ExpectBracket(
    [&](double size)
    {
      const PerforatedEnergy energy = compute(size);
      EXPECT_NEAR(energy.aligned, energy.alignedLower, 1e-3 * energy.aligned);
      return std::array<double, 2>{ energy.alignedLower, energy.alignedUpper };
    },
    exact);
  ExpectBracket(
    [&](double size)
    {
      const PerforatedEnergy energy = compute(size);
      return std::array<double, 2>{ energy.degreeOnlyLower, energy.degreeOnlyUpper };
    },
    exact);
}

TEST(PerforatedEnergy, BoundsOfARing)
{
  ExpectBracket(
    [](double size)
    {
      const PerforatedEnergy energy = Compute(Builtin("ring", size), {}, size);
      EXPECT_EQ(energy.degreeOnlyLower, 0.0);
      EXPECT_EQ(energy.degreeOnlyUpper, 0.0);
      return std::array<double, 2>{ energy.alignedLower, energy.alignedUpper };
    },
    16.0 * Pi * std::log(1.0 / 0.4));
}

TEST(PerforatedEnergy, BoundsOfAnEccentricHole)
{
  // docs/method.md §5: π d² acosh((1 + ρ² − s²) / (2ρ)).
  for (const auto& [distance, radius] : { std::pair{ 0.5, 0.2 }, std::pair{ 0.3, 0.1 } })
  {
    const double s = distance;
    const double rho = radius;
    const double exact = 16.0 * Pi * std::acosh((1.0 + rho * rho - s * s) / (2.0 * rho));
    ExpectBracket(
      [&](double size)
      {
        const PerforatedEnergy energy =
          Compute(Builtin("disk", size), { { { s * std::cos(0.7), s * std::sin(0.7) }, 4, rho } },
            size, static_cast<int>(2.4 / size));
        const double middle = 0.5 * (energy.degreeOnlyLower + energy.degreeOnlyUpper);
        EXPECT_NEAR(middle, exact, 0.005 * exact);
        return std::array<double, 2>{ energy.degreeOnlyLower, energy.degreeOnlyUpper };
      },
      exact);
  }
}

TEST(PerforatedEnergy, BoundsCloseInWhereTheFieldHasPeriods)
{
  // No exact value, but islands with a holonomy defect, whose periods both bounds must have alike.
  struct Case
  {
    PlanarDomain domain;
    Configuration holes;
  };
  const PlanarDomain two =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 2.0 }, { 0.0, 2.0 } },
      { { 0.6, 0.6 }, { 1.2, 0.6 }, { 1.2, 1.1 }, { 0.6, 1.1 } },
      { { 2.0, 0.9 }, { 2.5, 0.9 }, { 2.5, 1.5 }, { 2.0, 1.5 } } });
  const std::vector<Case> cases = {
    { Builtin("ring", 0.05), { { { 0.75, 0.05 }, 1, 0.06 }, { { -0.1, 0.65 }, -1, 0.06 } } },
    { two, { { { 1.6, 1.3 }, -1, 0.1 }, { { 1.6, 0.4 }, 1, 0.1 } } }
  };
  for (const Case& test : cases)
  {
    std::vector<double> gaps;
    std::vector<double> freeGaps;
    const std::vector<double> sizes = { 0.1, 0.05, 0.025 };
    for (const double size : sizes)
    {
      const PerforatedEnergy energy = Compute(test.domain, test.holes, size, 48);
      EXPECT_GT(std::abs(energy.holonomyDefect[0]), 0.05);
      gaps.push_back(energy.alignedUpper - energy.alignedLower);
      freeGaps.push_back(energy.degreeOnlyUpper - energy.degreeOnlyLower);
      EXPECT_GT(gaps.back(), 0.0);
      EXPECT_GT(freeGaps.back(), 0.0);
      EXPECT_LT(gaps.back(), 0.03 * energy.alignedLower);
      EXPECT_LT(energy.degreeOnlyUpper, energy.alignedLower); // less is asked of the field
    }
    EXPECT_LT(gaps.back(), 0.5 * gaps.front());
    EXPECT_LT(freeGaps.back(), 0.6 * freeGaps.front());
  }
}

TEST(PerforatedEnergy, IsThatOfTheUnitNormField)
{
  const TriangleMesh mesh = DrillHoles(Builtin("disk", 0.1), OnCircle(4, 0.6, 0.3, 1, 0.1));
  const double energy = SolveUnitNorm(ProblemOn(mesh)).energy;
  EXPECT_NEAR(ComputePerforatedEnergy(ShareTopology(mesh)).aligned, energy, 1e-10 * energy);
}

TEST(ConfigurationEnergy, SortsTheBestFirst)
{
  const double optimum = std::pow(3.0 / 11.0, 0.125);
  Configuration six = OnCircle(5, 0.6, 0.0, 1, 0.05);
  six.push_back({ { 0.0, 0.0 }, -1, 0.05 });
  const std::vector<Configuration> configurations = { six, OnCircle(3, 0.6, 0.0, 1, 0.05),
    OnCircle(4, 0.6, 0.3, 1, 0.05), OnCircle(4, optimum, 0.3, 1, 0.05) };
  ConfigurationEnergyOptions options;
  options.meshSize = 0.05;
  const auto energies = CompareConfigurations(Builtin("disk", 0.05), configurations, options);
  ASSERT_EQ(energies.size(), 4u);
  const std::vector<int> order = { 3, 2, 0, 1 };
  for (std::size_t i = 0; i < 4; ++i)
  {
    EXPECT_EQ(energies[i].configuration, order[i]);
    EXPECT_EQ(energies[i].consistent, i < 3);
  }
  EXPECT_NE(energies[3].reason.find("asks for 4"), std::string::npos);
  EXPECT_NEAR(energies[0].renormalized.energy, -7.2962, 0.02);
  EXPECT_NEAR(energies[1].renormalized.energy, 2.0498, 0.02);
  // docs/method.md §9.
  EXPECT_NEAR(energies[2].perforated.aligned, 47.16, 0.02 * 47.16);
  for (std::size_t i = 0; i < 3; ++i)
  {
    EXPECT_NEAR(energies[i].renormalized.logarithmCoefficient,
      Pi * static_cast<double>(energies[i].interior.size()), 1e-9);
  }
  EXPECT_TRUE(Refuses(
    [&] {
      CompareConfigurations(Builtin("disk", 0.1), { { { { 2.0, 0.0 }, 4, 0.1 } } });
    },
    { "outside the domain" }));
}

TEST(ConfigurationEnergy, WhereOnItsPolygonASingularityOfACurveLiesDoesNotDecide)
{
  // Three inside, one on the circle: 5π for all, so W decides. The worse ones are at vertices, whose
  // polygon is narrower than the circle.
  const auto at = [](double radius, Place place)
  {
    Configuration configuration = OnCircle(3, radius, 1.3, 1, 0.05);
    configuration.push_back(OnTheCircle(0.3, 1));
    return PutOnPolygon(128, 0.0, configuration, place).given;
  };
  const std::vector<Configuration> configurations = { at(0.2, Place::Vertex),
    at(0.75, Place::Middle), at(0.3, Place::Anywhere), at(0.5, Place::Middle) };
  ConfigurationEnergyOptions options;
  options.meshSize = 0.05;
  const auto energies = CompareConfigurations({ { RegularPolygon(128) } }, configurations, options);
  const std::vector<int> order = { 1, 3, 2, 0 };
  for (std::size_t i = 0; i < order.size(); ++i)
  {
    EXPECT_EQ(energies[i].configuration, order[i]);
    EXPECT_NEAR(energies[i].renormalized.logarithmCoefficient, 5.0 * Pi, 1e-11);
  }
}

TEST(ConfigurationEnergy, CoordinatesOfSinglePrecisionDoNotDecide)
{
  // One of four equal corners of a square, in any of them, without its quarter; turned and rounded.
  std::vector<Configuration> configurations;
  PlanarDomain square;
  const Similarity turn{ 0.4, 1.0, Point(3.0, 2.0) };
  square.loops = { turn(Loop{ { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } }) };
  for (Point& point : square.loops[0])
  {
    point = point.cast<float>().cast<double>();
  }
  for (std::size_t corner = 0; corner < 4; ++corner)
  {
    const double off = 0.1 * static_cast<double>(corner);
    configurations.push_back({ { square.loops[0][corner], 0, 0.0 },
      { turn(Loop{ Point(0.3 + off, 0.35) })[0], 1, 0.05 } });
  }
  ConfigurationEnergyOptions options;
  options.meshSize = 0.1;
  const auto energies = CompareConfigurations(square, configurations, options);
  for (std::size_t i = 1; i < energies.size(); ++i)
  {
    EXPECT_LT(energies[i - 1].renormalized.energy, energies[i].renormalized.energy);
  }
}
}
}
