// Singularities chosen for a domain, compared with the Poincaré-Hopf count, the symmetry of the
// domain and the exact minimum on the disk.

#include "AutomaticConfiguration.h"

#include "ConfigurationEnergy.h"
#include "ConfigurationSymmetry.h"
#include "DomainQueries.h"
#include "MakePlanarDomain.h"
#include "RenormalizedEnergy.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
Loop Box(double width, double height)
{
  return { { 0.0, 0.0 }, { width, 0.0 }, { width, height }, { 0.0, height } };
}

PlanarDomain BoxWithHole()
{
  return MakePlanarDomain({ Box(2.0, 1.5), RegularPolygon(32, 0.3, { 0.8, 0.7 }) });
}

/// Returns a plate with two holes on its middle line, which has two reflections.
PlanarDomain SymmetricPlate()
{
  return MakePlanarDomain({ Box(3.0, 1.4), RegularPolygon(32, 0.25, { 0.8, 0.7 }),
    RegularPolygon(32, 0.25, { 2.2, 0.7 }) });
}

/// Returns the minimum distance of singularities to the boundary and to each other; negative if one
/// is outside.
double LeastDistance(const PlanarDomain& domain, const Configuration& configuration)
{
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    least = std::min(least, SignedDistance(configuration[i].position, domain));
    for (std::size_t j = 0; j < i; ++j)
    {
      least = std::min(least, (configuration[i].position - configuration[j].position).norm());
    }
  }
  return least;
}

/// Returns W on a mesh of this size.
double EnergyOn(const PlanarDomain& domain, const Configuration& configuration, double meshSize)
{
  DrillOptions options;
  options.meshSize = meshSize;
  const PointPotential potential =
    PointPotentialOn(DrillHoles(domain, {}, options), {}, TotalQuarters(configuration));
  return EvaluateRenormalizedEnergy(potential, potential.Solve(configuration)).energy;
}

TEST(AutomaticConfiguration, OfTheDiskIsTheSquareOfLeastEnergy)
{
  // W/π = −12 log r − 8 log 2 − 4 log(1 − r⁸) is minimal at r⁸ = 3/11 (docs/method.md §5.3).
  const PlanarDomain disk = DiskOfEdges(0.05);
  const AutomaticConfiguration chosen = ChooseConfiguration(disk);
  EXPECT_TRUE(chosen.optimum.converged) << chosen.optimum.reason;
  ASSERT_EQ(chosen.singularities.size(), 4U);
  const double radius = std::pow(3.0 / 11.0, 0.125);
  const double angle = AngleBetween({ 1.0, 0.0 }, chosen.singularities[0].position);
  for (const Singularity& singularity : chosen.singularities)
  {
    EXPECT_EQ(singularity.quarterIndex, 1);
    EXPECT_NEAR(singularity.position.norm(), radius, 0.005);
    const double turn = AngleBetween({ 1.0, 0.0 }, singularity.position) - angle;
    EXPECT_NEAR(std::remainder(turn, 0.5 * Pi), 0.0, 0.01);
  }
  const double least =
    Pi * (-12.0 * std::log(radius) - 8.0 * std::log(2.0) - 4.0 * std::log(8.0 / 11.0));
  EXPECT_NEAR(chosen.optimum.energyAfter, least, 0.01 * std::abs(least));
}

TEST(AutomaticConfiguration, HasTheSumOfTheCountInsideTheDomain)
{
  // Sum: 4 (1 − inner loops) minus the quarter indices of corners.
  struct Case
  {
    const char* name;
    PlanarDomain domain;
    int sum;
  };
  const Case cases[] = { { "ring", RingOfEdges(0.1), 0 }, { "L", LShape(), 0 },
    { "pentagon", MakePlanarDomain({ RegularPolygon(5) }), 4 - 5 },
    { "plate", SymmetricPlate(), -4 - 4 }, { "box with a hole", BoxWithHole(), -4 } };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name);
    const AutomaticConfiguration chosen = ChooseConfiguration(one.domain);
    EXPECT_EQ(TotalQuarters(chosen.singularities), one.sum);
    EXPECT_GT(LeastDistance(one.domain, chosen.singularities), one.domain.Diagonal() / 400.0);
    EXPECT_TRUE(chosen.optimum.converged) << chosen.optimum.reason;
    for (const double defect : chosen.optimum.holonomyDefect)
    {
      EXPECT_NEAR(defect, 0.0, 1e-4); // without singularities, the error of the mesh
    }
    // A start of the search may be at its minimum, up to the barrier.
    EXPECT_LE(chosen.optimum.energyAfter,
      chosen.optimum.energyBefore + 3e-3 * (1.0 + std::abs(chosen.optimum.energyBefore)));
    EXPECT_FALSE(chosen.events.empty());
  }
}

TEST(AutomaticConfiguration, IsAsSymmetricAsTheDomain)
{
  const PlanarDomain domain = SymmetricPlate();
  const AutomaticConfiguration chosen = ChooseConfiguration(domain);
  for (const Isometry& element : FindSymmetries(domain).Elements())
  {
    for (const Singularity& singularity : chosen.singularities)
    {
      const Point image = element(singularity.position);
      EXPECT_TRUE(std::any_of(chosen.singularities.begin(), chosen.singularities.end(),
        [&](const Singularity& other)
        { return (other.position - image).norm() < 1e-9 * domain.Diagonal(); }))
        << Describe(image);
    }
  }
}

TEST(AutomaticConfiguration, IsALocalMinimumOnAnotherMesh)
{
  const PlanarDomain domain = MakePlanarDomain({ RegularPolygon(5) });
  const AutomaticConfiguration chosen = ChooseConfiguration(domain);
  const double size = 0.7 * domain.Diagonal() / 40.0;
  const double here = EnergyOn(domain, chosen.singularities, size);
  EXPECT_NEAR(here, chosen.optimum.energyAfter, 0.01 * (1.0 + std::abs(here)));
  for (int i = 0; i < 4; ++i)
  {
    Configuration moved = chosen.singularities;
    moved[0].position += 0.1 * Point(std::cos(0.5 * Pi * i), std::sin(0.5 * Pi * i));
    EXPECT_GT(EnergyOn(domain, moved, size), here);
  }
}

TEST(AutomaticConfiguration, KeepsAClearanceByTheSizeOfQuads)
{
  // At the minimum of the energy on the disk, singularities are 0.15 away from the boundary; sixty
  // quads have sides of 0.23.
  const PlanarDomain disk = DiskOfEdges(0.1);
  AutomaticOptions options;
  options.quadCount = 60;
  const double clearance = 0.7 * std::sqrt(disk.Area() / 60.0);
  const AutomaticConfiguration chosen = ChooseConfiguration(disk, options);
  EXPECT_EQ(TotalQuarters(chosen.singularities), 4);
  EXPECT_GT(LeastDistance(disk, chosen.singularities), clearance);
  EXPECT_LT(LeastDistance(disk, chosen.singularities), 1.3 * clearance);
  // A given clearance takes precedence.
  options.optimizer.clearance = 0.01;
  EXPECT_LT(LeastDistance(disk, ChooseConfiguration(disk, options).singularities), clearance);
}

TEST(AutomaticConfiguration, MovesOnToEvenSizesForQuads)
{
  const PlanarDomain plate =
    MakePlanarDomain({ Box(3.0, 1.4), RegularPolygon(32, 0.3, { 1.0, 0.6 }) });
  AutomaticOptions options;
  options.quadCount = 300;
  const AutomaticConfiguration least = ChooseConfiguration(plate, options);
  EXPECT_FALSE(least.optimum.sizeSpreads);
  options.optimizer.sizes.sizing = Sizing::Uniform;
  const AutomaticConfiguration even = ChooseConfiguration(plate, options);
  ASSERT_TRUE(even.optimum.sizeSpreads);
  EXPECT_LT(even.optimum.sizeSpreads->after, even.optimum.sizeSpreads->before);
  // As without target sizes, the energy determines the number of singularities.
  EXPECT_EQ(even.singularities.size(), least.singularities.size());
  EXPECT_GT(
    LeastDistance(plate, even.singularities), 0.7 * std::sqrt(plate.Area() / options.quadCount));
  EXPECT_NE(even.events.back().find("the spread of sizes from"), std::string::npos);
}

TEST(AutomaticConfiguration, EvensSizesForQuadsThatAreFarFromEven)
{
  // The energy attracts the one singularity that a triangle needs into its corner of 45 degrees,
  // whose optimal index is 3/2.
  const PlanarDomain triangle = MakePlanarDomain({ { { 0.0, 0.0 }, { 4.0, 0.0 }, { 1.0, 3.0 } } });
  AutomaticOptions options;
  options.quadCount = 1000;
  const AutomaticConfiguration chosen = ChooseConfiguration(triangle, options);
  ASSERT_EQ(chosen.singularities.size(), 1U);
  ASSERT_TRUE(chosen.optimum.sizeSpreads);
  EXPECT_GT(chosen.optimum.sizeSpreads->before, 0.5);
  EXPECT_LT(chosen.optimum.sizeSpreads->after, 0.35);
  EXPECT_GT(
    LeastDistance(triangle, chosen.singularities), 0.7 * std::sqrt(triangle.Area() / 1000.0));
  // On the disk, sizes are uniform enough at the minimum of the energy. Without quads, only the
  // energy is minimised.
  EXPECT_FALSE(ChooseConfiguration(DiskOfEdges(0.1), options).optimum.sizeSpreads);
  EXPECT_FALSE(ChooseConfiguration(triangle).optimum.sizeSpreads);
}

TEST(AutomaticConfiguration, AddsPairsForQuadsWhereTheyAreAllowed)
{
  // A ring whose gap is seven times as wide on one side as on the other. Sizes vary by the same
  // factor in a map without singularities.
  const PlanarDomain ring =
    MakePlanarDomain({ RegularPolygon(80), RegularPolygon(50, 0.4, { 0.45, 0.0 }) });
  AutomaticOptions options;
  options.quadCount = 1000;
  const AutomaticConfiguration needed = ChooseConfiguration(ring, options);
  EXPECT_NE(
    needed.events.back().find("pairs of singularities (Pairs, --pairs) may"), std::string::npos);
  options.optimizer.pairs = 2;
  const AutomaticConfiguration more = ChooseConfiguration(ring, options);
  EXPECT_EQ(TotalQuarters(more.singularities), TotalQuarters(needed.singularities));
  EXPECT_GT(more.singularities.size(), needed.singularities.size());
  EXPECT_LE(more.singularities.size(), needed.singularities.size() + 4);
  EXPECT_LT(more.optimum.sizeSpread, 0.5 * needed.optimum.sizeSpread);
  EXPECT_GT(LeastDistance(ring, more.singularities), 0.7 * std::sqrt(ring.Area() / 1000.0));
}

TEST(AutomaticConfiguration, NothingIsNeededWhereCornersDoIt)
{
  const AutomaticConfiguration chosen = ChooseConfiguration(LShape());
  EXPECT_TRUE(chosen.singularities.empty());
  EXPECT_NE(chosen.events.front().find("needs no singularities"), std::string::npos);
}

TEST(AutomaticConfiguration, AddsNoPairWhereNoSingularityIsNeeded)
{
  // Rings have a conformal map to a rectangle, and in a square with a parallel slot the crosses are
  // constant: there is a field without singularities and without a defect.
  struct Case
  {
    const char* name;
    PlanarDomain domain;
  };
  const auto ring = [](double radius, double shift) {
    return MakePlanarDomain({ RegularPolygon(150), RegularPolygon(120, radius, { shift, 0.0 }) });
  };
  const auto slot = [](double x, double y, double width, double height)
  {
    Loop inner = Box(width, height);
    for (Point& point : inner)
    {
      point += Point(x, y);
    }
    return MakePlanarDomain({ Box(2.0, 2.0), inner });
  };
  const Case cases[] = { { "ring of 0.84", ring(0.84, 0.0) }, { "ring of 0.91", ring(0.91, 0.0) },
    { "eccentric ring", ring(0.88, 0.03) }, { "slot in the middle", slot(0.5, 0.98, 1.0, 0.04) },
    { "slot at the side", slot(0.3, 0.2, 0.12, 1.4) } };
  for (const Case& one : cases)
  {
    SCOPED_TRACE(one.name);
    AutomaticOptions options;
    options.quadCount = 1000;
    const AutomaticConfiguration chosen = ChooseConfiguration(one.domain, options);
    EXPECT_TRUE(chosen.singularities.empty());
    ASSERT_EQ(chosen.optimum.holonomyDefect.size(), 1U);
    EXPECT_NEAR(chosen.optimum.holonomyDefect[0], 0.0, 1e-3);
  }
}

TEST(AutomaticConfiguration, RanksNoPairAheadOfOneWhoseCoresOverlap)
{
  // The cores of the comparison have a radius of 0.028, more than the distance of the pair.
  const FactoredDomain ring(
    MakePlanarDomain({ RegularPolygon(150), RegularPolygon(120, 0.9) }), {}, 0.0);
  const Configuration pair = { { { 0.0, -0.959 }, 1, 0.0 }, { { 0.0, -0.938 }, -1, 0.0 } };
  const auto energies = CompareRenormalizedEnergies(ring, { pair, {} });
  ASSERT_EQ(energies.size(), 2U);
  EXPECT_EQ(energies[0].configuration, 1);
  const RenormalizedEnergyValue& value = energies[1].renormalized;
  EXPECT_LT(value.energy - value.logarithmCoefficient * std::log(energies[1].coreRadius),
    energies[0].atCoreRadius);
}

TEST(AutomaticConfiguration, SingularitiesOfThinCornersAreInside)
{
  const PlanarDomain triangle = MakePlanarDomain({ { { 0.0, 0.0 }, { 10.0, 0.0 }, { 9.0, 1.0 } } });
  AutomaticOptions options;
  CapCorners(triangle, options);
  const AutomaticConfiguration chosen = ChooseConfiguration(triangle, options);
  ASSERT_EQ(chosen.singularities.size(), 1U);
  EXPECT_GT(SignedDistance(chosen.singularities[0].position, triangle), 1e-4 * triangle.Diagonal());
}
}
}
