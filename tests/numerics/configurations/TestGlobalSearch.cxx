// The search among candidate sites: its quadratic form against the energies of StrengthChanges, and
// its results on parts with holes on a circle against known minima.

#include "GlobalSearch.h"

#include "CandidateSites.h"
#include "DomainQueries.h"
#include "MakePlanarDomain.h"
#include "OptimizerStage.h"
#include "SingularityOptimizer.h"
#include "StageBoundary.h"
#include "StrengthChanges.h"
#include "Support.h"

#include <cmath>
#include <limits>
#include <map>
#include <random>

namespace crossfield::test
{
namespace
{
/// Returns a disk or ring with holes on a circle, each turned with its place.
PlanarDomain WithHoles(int count, double radius, double distance, double bore = 0.0)
{
  std::vector<Loop> loops = { RegularPolygon(60 * count, 1.0) };
  if (bore > 0.0)
  {
    loops.push_back(RegularPolygon(24 * count, bore));
  }
  for (int i = 0; i < count; ++i)
  {
    const double angle = 2.0 * Pi * i / count;
    const Point centre = distance * Point(std::cos(angle), std::sin(angle));
    Loop hole;
    constexpr int Vertices = 32;
    for (int j = 0; j < Vertices; ++j)
    {
      const double turn = angle + 2.0 * Pi * j / Vertices;
      hole.push_back(centre + radius * Point(std::cos(turn), std::sin(turn)));
    }
    loops.push_back(hole);
  }
  return MakePlanarDomain(loops);
}

std::map<int, int> CountIndices(const Configuration& configuration)
{
  std::map<int, int> counts;
  for (const Singularity& singularity : configuration)
  {
    ++counts[singularity.quarterIndex];
  }
  return counts;
}

/// Returns the energy at a hundredth of the diagonal after optimisation with the clearance for 1,500
/// quads.
double OptimizedEnergy(const PlanarDomain& domain, const Configuration& start)
{
  OptimizerOptions options;
  options.keepAll = true;
  options.clearance = 0.7 * std::sqrt(domain.Area() / 1500.0);
  const OptimizerResult result = OptimizeSingularities(domain, start, options);
  return result.energyAfter -
    Pi * static_cast<double>(start.size()) * std::log(domain.Diagonal() / 100.0);
}
}

TEST(GlobalSearch, FormEqualsEnergiesOfChanges)
{
  const PlanarDomain domain = WithHoles(2, 0.15, 0.5);
  const Configuration given = { { { 0.0, 0.3 }, -3, 0.0 }, { { 0.1, -0.4 }, -1, 0.0 } };
  StageOptions options;
  options.objective.clearance = 0.01;
  const OptimizerStage stage =
    MakeStage(domain, { given, std::vector<int>(given.size(), 0), {} }, options);
  const Corner vertex = BoundaryVertices(stage).vertices[5];
  StrengthChanges changes(stage.objective->Energy(), given);
  const std::vector<StrengthChanges::Place> places = { { given[0].position, -1 },
    { given[1].position, -1 }, { { 0.0, -0.7 }, -1 }, { { 0.75, 0.2 }, -1 },
    { vertex.position, stage.potential->GetProblem().Topology().VertexOf(vertex) } };
  changes.Prepare(places);
  const double radius = domain.Diagonal() / 400.0;
  const StrengthChanges::Form form = changes.FormAt(places, radius);
  const auto energy = [&](const StrengthChanges::Value& value)
  { return value.energy - value.logarithmCoefficient * std::log(radius); };
  const double start = energy(changes.Evaluate({}));
  // Of the nearest multiples of 2π, which are those of the wrapped angles or next to them.
  const auto defectEnergy = [&](const Eigen::VectorXd& defects)
  {
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 9; ++i)
    {
      Eigen::VectorXd near = defects.unaryExpr([](double d) { return WrapAngle(d); });
      near += 2.0 * Pi * Eigen::Vector2d(i % 3 - 1, i / 3 - 1);
      lowest = std::min(lowest, 0.5 * near.dot(form.defectEnergy * near));
    }
    return lowest;
  };
  std::mt19937 random(7);
  for (int trial = 0; trial < 20; ++trial)
  {
    Eigen::VectorXd delta(5);
    std::vector<StrengthChanges::Change> list;
    int sum = 0;
    for (int i = 0; i < 5; ++i)
    {
      const int change = i < 4 ? static_cast<int>(random() % 5) - 2 : -sum;
      sum += change;
      delta[i] = change;
      list.push_back({ places[static_cast<std::size_t>(i)], change });
    }
    const double expected = form.linear.dot(delta) + 0.5 * delta.dot(form.matrix * delta) +
      defectEnergy(form.defects + form.defectChanges * delta) - defectEnergy(form.defects);
    const double actual = energy(changes.Evaluate(list)) - start;
    EXPECT_NEAR(actual, expected, 1e-8 * (1.0 + std::abs(actual)));
  }
}

TEST(GlobalSearch, FindsKnownMinima)
{
  struct Known
  {
    PlanarDomain domain;
    std::map<int, int> counts;
    std::size_t symmetries;
    double energy; ///< At a hundredth of the diagonal.
  };
  const Known parts[] = { { WithHoles(3, 0.1, 0.6), { { 1, 1 }, { -1, 9 } }, 6, 98.7 },
    { WithHoles(5, 0.1, 0.65), { { -1, 16 } }, 10, 132.4 },
    { WithHoles(2, 0.15, 0.5), { { -1, 4 } }, 4, 86.8 },
    { WithHoles(6, 0.09, 0.7, 0.4), { { -1, 24 } }, 12, 134.4 },
    { WithHoles(4, 0.09, 0.7, 0.4), { { -1, 16 } }, 8, 105.2 } };
  for (const Known& part : parts)
  {
    const std::vector<SearchedConfiguration> found = SearchConfigurations(part.domain);
    ASSERT_FALSE(found.empty());
    EXPECT_EQ(CountIndices(found[0].singularities), part.counts);
    EXPECT_EQ(found[0].symmetries, part.symmetries);
    EXPECT_NEAR(
      OptimizedEnergy(part.domain, found[0].singularities), part.energy, 0.01 * part.energy);
  }
}

TEST(GlobalSearch, OtherMinimaFollow)
{
  // Three holes: a minimum with eight singularities and one reflection is little higher.
  const std::vector<SearchedConfiguration> found = SearchConfigurations(WithHoles(3, 0.1, 0.6));
  ASSERT_GE(found.size(), 2U);
  EXPECT_EQ(CountIndices(found[1].singularities), (std::map<int, int>{ { -1, 8 } }));
  EXPECT_EQ(found[1].symmetries, 2U);
  for (std::size_t i = 1; i < found.size(); ++i)
  {
    EXPECT_GE(found[i].objective, found[i - 1].objective);
  }
}

TEST(GlobalSearch, IsInvariant)
{
  const PlanarDomain domain = WithHoles(3, 0.1, 0.6);
  PlanarDomain moved = domain;
  const Eigen::Rotation2Dd turn(0.4);
  for (Loop& loop : moved.loops)
  {
    for (Point& point : loop)
    {
      point = 3.0 * (turn * point) + Point(100.0, -20.0);
    }
  }
  const auto found = SearchConfigurations(domain);
  const auto again = SearchConfigurations(moved);
  for (const auto& [one, other] : { std::make_pair(found[0], again[0]), { found[1], again[1] } })
  {
    EXPECT_EQ(CountIndices(one.singularities), CountIndices(other.singularities));
    EXPECT_EQ(one.symmetries, other.symmetries);
  }
  // The lattice of sites is not turned with the domain: minima are nearer to some site, or farther.
  EXPECT_NEAR(
    found[1].objective - found[0].objective, again[1].objective - again[0].objective, 2.0);
}

TEST(GlobalSearch, NeedsNothing)
{
  // A square has the sum 0 and no better configuration than none.
  const auto found = SearchConfigurations(
    MakePlanarDomain({ { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 } } }));
  ASSERT_FALSE(found.empty());
  EXPECT_TRUE(found[0].singularities.empty());
}

TEST(GlobalSearch, LeavesRoundedCornersToTheField)
{
  // The ends of a slender body are on its boundary if quads do not resolve them.
  Loop body;
  constexpr int Vertices = 200;
  for (int i = 0; i < Vertices; ++i)
  {
    const double angle = 2.0 * Pi * i / Vertices;
    body.push_back({ 0.5 * std::cos(angle), 0.1 * std::sin(angle) });
  }
  const PlanarDomain domain =
    MakePlanarDomain({ { { -2.0, -1.5 }, { 2.0, -1.5 }, { 2.0, 1.5 }, { -2.0, 1.5 } }, body });
  ProposalOptions options;
  options.quadSize = 0.1;
  EXPECT_TRUE(SearchConfigurations(domain, options).empty());
  options.quadSize = 0.01;
  EXPECT_FALSE(SearchConfigurations(domain, options).empty());
}

TEST(GlobalSearch, OneMorePairFollows)
{
  // In a drop with a cusp, two singularities and four have nearly the same energy.
  Loop drop;
  constexpr int Vertices = 160;
  for (int i = 0; i < Vertices; ++i)
  {
    const double angle = 2.0 * Pi * i / Vertices;
    drop.push_back({ std::cos(angle), std::sin(angle) * std::pow(std::sin(0.5 * angle), 2) });
  }
  const auto found = SearchConfigurations(MakePlanarDomain({ drop }));
  ASSERT_GE(found.size(), 2U);
  EXPECT_EQ(found[1].singularities.size(), found[0].singularities.size() + 2);
  EXPECT_LT(found[1].objective, found[0].objective + 8.0);
}

TEST(CandidateSites, AreClosedUnderSymmetries)
{
  const PlanarDomain domain = WithHoles(5, 0.1, 0.65);
  const double clearance = 0.02;
  const CandidateSites sites = FindCandidateSites(domain, clearance);
  ASSERT_EQ(sites.elements.size(), 10U);
  EXPECT_GT(sites.positions.size(), 300U);
  for (std::size_t g = 0; g < sites.elements.size(); ++g)
  {
    for (std::size_t i = 0; i < sites.positions.size(); ++i)
    {
      const Point image = sites.elements[g](sites.positions[i]);
      EXPECT_LT((sites.positions[sites.images[g][i]] - image).norm(), 1e-8);
    }
  }
  for (const Point& site : sites.positions)
  {
    EXPECT_GE(SignedDistance(site, domain), 0.999 * clearance);
  }
}
}
