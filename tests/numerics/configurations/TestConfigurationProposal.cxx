// Proposals are consistent, close to minima of the energy, and ranked by comparable energies.

#include "ConfigurationEnergy.h"
#include "ConfigurationPairs.h"
#include "ConfigurationProposal.h"
#include "ConfigurationSymmetry.h"
#include "DomainQueries.h"
#include "FieldConfiguration.h"
#include "MakePlanarDomain.h"
#include "PoincareHopf.h"
#include "SingularityOptimizer.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns the singularities of the best proposal.
Configuration ProposeConfiguration(const PlanarDomain& domain, const ProposalOptions& options = {})
{
  return ProposeConfigurations(domain, options).front().singularities;
}

Loop Rectangle(double width, double height)
{
  return { { 0.0, 0.0 }, { width, 0.0 }, { width, height }, { 0.0, height } };
}

/// Returns a plate of 120 by 80 with three round holes.
PlanarDomain Plate()
{
  return MakePlanarDomain({ Rectangle(120.0, 80.0), RegularPolygon(60, 12.0, { 30.0, 40.0 }),
    RegularPolygon(60, 8.0, { 75.0, 25.0 }), RegularPolygon(60, 8.0, { 85.0, 58.0 }) });
}

/// Returns W of a configuration, without moving it.
double EnergyOf(const PlanarDomain& domain, const Configuration& configuration)
{
  OptimizerOptions options;
  options.maximumIterations = 0;
  return OptimizeSingularities(domain, configuration, options).energyBefore;
}

TEST(ConfigurationProposal, KeepsSingularitiesInsideANeck)
{
  // On the axis x = 1 the domain is lower than 0.001.
  const PlanarDomain domain = MakePlanarDomain(
    { { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 0.001 }, { 0.0, 1.0 } } });
  Configuration singularities = { { { 1.01, 0.005 }, 1, 0.0 } };
  EXPECT_FALSE(MakeSymmetric(domain, FindSymmetries(domain), 0.05, singularities));
  EXPECT_EQ(singularities[0].position, Point(1.01, 0.005));
  for (const ProposedConfiguration& proposal : ProposeConfigurations(domain))
  {
    for (const Singularity& singularity : proposal.singularities)
    {
      EXPECT_GT(SignedDistance(singularity.position, domain), 0.0);
    }
  }
}

TEST(ConfigurationProposal, IsConsistentWithItsCorners)
{
  for (const char* name : { "ring", "quarter-disk", "hexagonal", "star", "angular-hole" })
  {
    SCOPED_TRACE(name);
    const PlanarDomain domain = Builtin(name);
    ProposalOptions options;
    options.chooseCorners = true;
    options.variations = true;
    const std::vector<ProposedConfiguration> proposals = ProposeConfigurations(domain, options);
    ASSERT_FALSE(proposals.empty());
    for (const ProposedConfiguration& proposal : proposals)
    {
      SCOPED_TRACE(proposal.origin);
      EXPECT_EQ(TotalQuarters(proposal.singularities), Required(domain, proposal.corners));
      EXPECT_NO_THROW(DrillHoles(domain, proposal.singularities));
      EXPECT_TRUE(std::isfinite(proposal.energy));
    }
    EXPECT_FALSE(proposals[0].variation);
    for (std::size_t i = 2; i < proposals.size(); ++i)
    {
      EXPECT_LE(proposals[i - 1].energy, proposals[i].energy);
    }
  }
}

TEST(ConfigurationProposal, ExcludesOverlappingPairs)
{
  // If no singularity is needed, the two singularities of an additional pair meet. When they were a
  // hundredth of the diagonal of the L apart, their energy at the core radius was below that of no
  // singularity.
  const PlanarDomain domain = Builtin("l-shape");
  ProposalOptions options;
  options.variations = true;
  const std::vector<ProposedConfiguration> proposals = ProposeConfigurations(domain, options);
  EXPECT_TRUE(proposals.at(0).singularities.empty());
  for (const ProposedConfiguration& proposal : proposals)
  {
    for (std::size_t i = 0; i < proposal.singularities.size(); ++i)
    {
      for (std::size_t j = 0; j < i; ++j)
      {
        EXPECT_GE((proposal.singularities[i].position - proposal.singularities[j].position).norm(),
          0.02 * domain.Diagonal())
          << proposal.origin;
      }
    }
  }
}

TEST(ConfigurationProposal, FieldHasLowerEnergyThanSpread)
{
  // Four singularities of −1 around each hole, at the distance of their natural positions: 80
  // instead of 278 was measured.
  const PlanarDomain plate = Plate();
  const FieldConfiguration field = ReadConfiguration(plate, SolveCoarseField(plate));
  EXPECT_EQ(field.singularities.size(), 12u);
  EXPECT_LT(
    EnergyOf(plate, field.singularities), 0.5 * EnergyOf(plate, SpreadConfiguration(plate)));
  EXPECT_LT(
    EnergyOf(plate, ProposeConfiguration(plate)), 1.1 * EnergyOf(plate, field.singularities));
}

TEST(ConfigurationProposal, FindsMinimumOnDisk)
{
  // Four singularities of +1 on the circle of radius 0.850 (docs/method.md §9).
  const Configuration proposal = ProposeConfiguration(Builtin("disk"));
  ASSERT_EQ(proposal.size(), 4u);
  for (const Singularity& singularity : proposal)
  {
    EXPECT_EQ(singularity.quarterIndex, 1);
    EXPECT_NEAR(singularity.position.norm(), 0.85, 0.03);
  }
}

TEST(ConfigurationProposal, IsEmptyIfNoSingularityIsNeeded)
{
  EXPECT_TRUE(ProposeConfiguration(Builtin("square")).empty());
  EXPECT_TRUE(ProposeConfiguration(Builtin("l-shape")).empty());
  EXPECT_TRUE(ProposeConfiguration(Builtin("ring")).empty()) << "its defect is zero";
}

TEST(ConfigurationProposal, KeepsGivenSingularities)
{
  ProposalOptions options;
  options.given = { { Point(0.3, 0.0), -1, 0.05 }, { Point(-0.3, 0.0), 2, 0.1 } };
  const PlanarDomain disk = Builtin("disk");
  const Configuration proposal = ProposeConfiguration(disk, options);
  ASSERT_GE(proposal.size(), 5u);
  EXPECT_EQ(proposal[0].position, options.given[0].position);
  EXPECT_EQ(proposal[1].quarterIndex, 2);
  EXPECT_EQ(TotalQuarters(proposal), 4);
  options.given[0].position = Point(3.0, 0.0);
  EXPECT_TRUE(Refuses([&] { ProposeConfiguration(disk, options); }, { "outside" }));
}

TEST(ConfigurationProposal, RanksByEnergyAtCoreRadius)
{
  // On the disk, W of two singularities of k = 2 is lower than that of four of k = 1, which are
  // much better nevertheless.
  const PlanarDomain disk = Builtin("disk", 0.02);
  const Configuration four = OnCircle(4, 0.42 * std::sqrt(2.0), 0.25 * Pi, 1, 0.01);
  const Configuration two = OnCircle(2, 0.5, 0.0, 2, 0.01);
  EXPECT_LT(EnergyOf(disk, two), EnergyOf(disk, four));
  const double radius = 0.01 * disk.Diagonal();
  const auto energy = [&](const Configuration& configuration)
  {
    return EnergyOf(disk, configuration) -
      LogarithmCoefficient(disk, configuration) * std::log(radius);
  };
  EXPECT_GT(energy(two), energy(four) + 10.0);
  ProposalOptions options;
  options.variations = true;
  const auto proposals = ProposeConfigurations(disk, options);
  ASSERT_GE(proposals.size(), 2u);
  EXPECT_FALSE(proposals.front().variation);
  EXPECT_EQ(proposals.front().singularities.size(), 4u);
  const auto merged = std::find_if(proposals.begin(), proposals.end(),
    [](const ProposedConfiguration& proposal) { return proposal.singularities.size() == 3; });
  ASSERT_NE(merged, proposals.end());
  EXPECT_GT(merged->energy, proposals.front().energy);
}

TEST(ConfigurationProposal, HasSymmetriesOfDomain)
{
  // A plate with four holes has two reflections.
  std::vector<Loop> loops = { Rectangle(4.0, 2.4) };
  for (const Point& centre : { Point(1.0, 0.7), Point(3.0, 0.7), Point(1.0, 1.7), Point(3.0, 1.7) })
  {
    loops.push_back(RegularPolygon(24, 0.25, centre));
  }
  for (const PlanarDomain& domain : { MakePlanarDomain(loops), Builtin("disk"), Builtin("star") })
  {
    const Configuration proposal = ProposeConfiguration(domain);
    ASSERT_FALSE(proposal.empty());
    const ConfigurationSymmetry symmetry =
      MatchSymmetry(proposal, FindSymmetries(domain), 1e-9 * domain.Diagonal());
    EXPECT_FALSE(symmetry.IsTrivial());
  }
}

TEST(ConfigurationProposal, CoefficientMatchesComputedEnergies)
{
  for (const char* name : { "disk", "star", "quarter-disk" })
  {
    SCOPED_TRACE(name);
    const PlanarDomain domain = Builtin(name);
    const Configuration proposal = ProposeConfiguration(domain);
    const auto energies = CompareConfigurations(domain, { proposal });
    // Where an arc meets a line, the angle of the polygon differs from that of the curves by half
    // of the turn of an edge.
    EXPECT_NEAR(
      LogarithmCoefficient(domain, proposal), energies[0].renormalized.logarithmCoefficient, 1e-2);
  }
}

TEST(ConfigurationProposal, IsScaleInvariant)
{
  const PlanarDomain star = Builtin("star");
  const Configuration plain = ProposeConfiguration(star);
  for (const double scale : { 1e-6, 1e6 })
  {
    const Similarity move{ 0.0, scale, Point::Zero() };
    const Configuration scaled = ProposeConfiguration(move(star));
    ASSERT_EQ(scaled.size(), plain.size());
    for (std::size_t i = 0; i < plain.size(); ++i)
    {
      EXPECT_NEAR((scaled[i].position / scale - plain[i].position).norm(), 0.0, 1e-3);
    }
  }
}

TEST(ConfigurationPairs, CancelsMergesAndAdds)
{
  const PlanarDomain disk = Builtin("disk");
  Configuration row = { { Point(0.0, 0.0), 1, 0.0 }, { Point(0.1, 0.0), -1, 0.0 },
    { Point(0.15, 0.0), 1, 0.0 }, { Point(0.9, 0.0), -1, 0.0 } };
  Configuration near = row;
  CancelOpposites(near, 0.2);
  ASSERT_EQ(near.size(), 2u);
  EXPECT_EQ(near[0].position, row[0].position) << "the closest pair is removed first";
  CancelOpposites(near, 10.0);
  EXPECT_TRUE(near.empty());

  EXPECT_TRUE(MergeNearest(disk, row));
  ASSERT_EQ(row.size(), 3u);
  EXPECT_EQ(row[0].quarterIndex, 2);
  EXPECT_EQ(row[0].position, Point(0.075, 0.0));
  EXPECT_TRUE(AddPair(disk, row));
  EXPECT_EQ(TotalQuarters(row), 0);
  Configuration opposite = { { Point(0.0, 0.0), 1, 0.0 }, { Point(0.5, 0.0), -1, 0.0 } };
  EXPECT_FALSE(MergeNearest(disk, opposite));
}
}
}
