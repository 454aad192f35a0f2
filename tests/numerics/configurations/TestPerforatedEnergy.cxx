#include "MakePlanarDomain.h"
#include "PerforatedEnergy.h"

#include "ConfigurationEnergy.h"
#include "DrillHoles.h"
#include "EnergyMesh.h"
#include "Support.h"
#include "UnitNormField.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Computes bounds on the default mesh for energies.
PerforatedEnergy Compute(
  const PlanarDomain& domain, const Configuration& holes, double meshSize, int holeEdges = 0)
{
  DrillOptions options = DrillForEnergies(domain, holes, meshSize);
  options.minimumHoleEdges = holeEdges > 0 ? holeEdges : options.minimumHoleEdges;
  return ComputePerforatedEnergy(ShareTopology(DrillHoles(domain, holes, options)));
}

/// Mesh sizes below the default size of the disk and the ring, 0.07.
const std::vector<double> Sizes = { 0.06, 0.03, 0.015 };

/// Expects that the exact energy is between the bounds on every mesh, and that their gap closes at
/// second order.
void ExpectBracket(const std::function<std::array<double, 2>(double)>& bounds, double exact)
{
  std::vector<double> gaps;
  for (const double size : Sizes)
  {
    SCOPED_TRACE(size);
    const auto [lower, upper] = bounds(size);
    EXPECT_LE(lower, exact * (1.0 + 1e-12));
    EXPECT_GE(upper, exact * (1.0 - 1e-12));
    gaps.push_back(upper - lower);
  }
  EXPECT_GE(ConvergenceRate(Sizes, gaps), 1.8);
  EXPECT_LT(gaps.back(), 2e-3 * exact);
}

TEST(PerforatedEnergy, MeanOfBoundsIsExactForCentredHole)
{
  const double exact = 16.0 * Pi * std::log(1.0 / 0.3);
  for (const double size : Sizes)
  {
    SCOPED_TRACE(size);
    const int edges = static_cast<int>(2.0 * Pi * 0.3 / size) + 8;
    const PlanarDomain disk = Builtin("disk", size);
    const PerforatedEnergy energy = Compute(disk, { { { 0.0, 0.0 }, 4, 0.3 } }, size, edges);
    const double gap = energy.alignedUpper - energy.alignedLower;
    EXPECT_LT(energy.alignedLower, exact);
    EXPECT_GT(energy.alignedUpper, exact);
    EXPECT_LT(gap, 95.0 * size * size);
    // docs/method.md §5.2: the polygon of the hole is narrower than its circle. The polygon of the
    // disk is also inside its circle, by s²/12 on average for sides of length s; Φ = 4 log r, with
    // a total flux of 8π, is lower there by the corresponding amount.
    const double side = (disk.loops[0][1] - disk.loops[0][0]).norm();
    const double polygons = exact + 16.0 * std::pow(Pi, 3) / (3.0 * edges * edges) -
      0.5 * 8.0 * Pi * 4.0 * side * side / 12.0;
    EXPECT_NEAR(energy.Aligned(), polygons, 0.05 * gap);
    EXPECT_NEAR(energy.DegreeOnly(), polygons, 0.05 * gap);
  }
}

TEST(PerforatedEnergy, BoundsEncloseExactEnergyOfRing)
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

TEST(PerforatedEnergy, BoundsEncloseExactEnergyOfEccentricHole)
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
        const PerforatedEnergy energy = Compute(
          Builtin("disk", size), { { { s * std::cos(0.7), s * std::sin(0.7) }, 4, rho } }, size);
        EXPECT_NEAR(energy.DegreeOnly(), exact, 0.5 * size * size * exact);
        return std::array<double, 2>{ energy.degreeOnlyLower, energy.degreeOnlyUpper };
      },
      exact);
  }
}

/// Cases without an exact value: a square, the L with its re-entrant corner, and islands with a
/// holonomy defect.
struct BoundedCase
{
  PlanarDomain domain;
  Configuration holes;
};

std::vector<BoundedCase> BoundedCases()
{
  const PlanarDomain two =
    MakePlanarDomain({ { { 0.0, 0.0 }, { 3.0, 0.0 }, { 3.0, 2.0 }, { 0.0, 2.0 } },
      { { 0.6, 0.6 }, { 1.2, 0.6 }, { 1.2, 1.1 }, { 0.6, 1.1 } },
      { { 2.0, 0.9 }, { 2.5, 0.9 }, { 2.5, 1.5 }, { 2.0, 1.5 } } });
  return { { Builtin("square"), { { { 0.25, 0.25 }, 1, 0.1 }, { { 0.75, 0.75 }, -1, 0.1 } } },
    { LShape(), { { { 0.5, 0.5 }, 1, 0.05 }, { { 1.4, 0.4 }, -1, 0.05 } } },
    { Builtin("ring", 0.05), { { { 0.75, 0.05 }, 1, 0.06 }, { { -0.1, 0.65 }, -1, 0.06 } } },
    { two, { { { 1.6, 1.3 }, -1, 0.1 }, { { 1.6, 0.4 }, 1, 0.1 } } } };
}

TEST(ConfigurationEnergy, GapClosesAtSecondOrder)
{
  for (const BoundedCase& test : BoundedCases())
  {
    std::vector<double> sizes;
    std::vector<double> gaps;
    std::vector<double> freeGaps;
    for (const double fraction : { 1.0, 0.4 })
    {
      ConfigurationEnergyOptions options;
      options.meshSize = fraction * test.domain.Diagonal() / 40.0;
      const PerforatedEnergy energy =
        CompareConfigurations(test.domain, { test.holes }, options).at(0).perforated.value();
      sizes.push_back(options.meshSize);
      gaps.push_back(energy.alignedUpper - energy.alignedLower);
      freeGaps.push_back(energy.degreeOnlyUpper - energy.degreeOnlyLower);
      EXPECT_GT(gaps.back(), 0.0);
      EXPECT_GT(freeGaps.back(), 0.0);
      EXPECT_LT(energy.DegreeOnly(), energy.Aligned()); // there are fewer conditions on the field
    }
    EXPECT_GE(ConvergenceRate(sizes, gaps), 1.8);
    EXPECT_GE(ConvergenceRate(sizes, freeGaps), 1.8);
  }
}

TEST(PerforatedEnergy, MeanOfBoundsIsCloseToLimit)
{
  // Both bounds tend to the energy of this polygon when each triangle is divided into four.
  for (const BoundedCase& test : BoundedCases())
  {
    TriangleMesh mesh =
      DrillHoles(test.domain, test.holes, DrillForEnergies(test.domain, test.holes, 0.0));
    std::vector<PerforatedEnergy> levels;
    for (int level = 0; level < 3; ++level)
    {
      levels.push_back(ComputePerforatedEnergy(ShareTopology(mesh)));
      mesh = Refine(mesh);
    }
    const auto limit = [&levels](double (*value)(const PerforatedEnergy&))
    {
      const double last = value(levels[2]);
      return last + (last - value(levels[1])) / 3.0;
    };
    const double lower = limit([](const PerforatedEnergy& e) { return e.alignedLower; });
    const double upper = limit([](const PerforatedEnergy& e) { return e.alignedUpper; });
    const double gap = levels[0].alignedUpper - levels[0].alignedLower;
    EXPECT_NEAR(lower, upper, 0.02 * gap);
    EXPECT_NEAR(levels[0].Aligned(), 0.5 * (lower + upper), 0.1 * gap) << gap;
    const double freeLower = limit([](const PerforatedEnergy& e) { return e.degreeOnlyLower; });
    const double freeUpper = limit([](const PerforatedEnergy& e) { return e.degreeOnlyUpper; });
    EXPECT_NEAR(levels[0].DegreeOnly(), 0.5 * (freeLower + freeUpper),
      0.1 * (levels[0].degreeOnlyUpper - levels[0].degreeOnlyLower));
  }
}

TEST(PerforatedEnergy, LowerBoundEqualsUnitNormEnergyOnUndividedSides)
{
  const TriangleMesh mesh =
    DrillHoles(LShape(), { { { 0.5, 0.5 }, 1, 0.1 }, { { 1.4, 0.4 }, -1, 0.1 } });
  const double energy = SolveUnitNorm(ProblemOn(mesh)).energy;
  EXPECT_NEAR(ComputePerforatedEnergy(ShareTopology(mesh)).alignedLower, energy, 1e-10 * energy);
}

TEST(ConfigurationEnergy, SortsByEnergy)
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
  EXPECT_NE(energies[3].reason.find("requires 4"), std::string::npos);
  EXPECT_NEAR(energies[0].renormalized.energy, -7.2962, 0.02);
  EXPECT_NEAR(energies[1].renormalized.energy, 2.0498, 0.02);
  // docs/method.md §9.
  EXPECT_NEAR(energies[2].perforated->Aligned(), 47.16, 0.02 * 47.16);
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

TEST(ConfigurationEnergy, OrderDoesNotDependOnPositionOnPolygon)
{
  // Three interior singularities and one on the circle: the coefficient is 5π for all, so W
  // decides. The worse configurations have theirs at vertices, where the polygon is narrower than
  // the circle.
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

TEST(ConfigurationEnergy, OrderDoesNotDependOnSinglePrecision)
{
  // A square, rotated and rounded to single precision, with one of its four equal corners without
  // its quarter.
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
    const double shift = 0.1 * static_cast<double>(corner);
    configurations.push_back({ { square.loops[0][corner], 0, 0.0 },
      { turn(Loop{ Point(0.3 + shift, 0.35) })[0], 1, 0.05 } });
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
