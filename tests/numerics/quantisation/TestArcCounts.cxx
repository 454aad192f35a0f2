#include "ArcCounts.h"

#include "ArcFlow.h"
#include "ArcImprovement.h"
#include "ArcProgram.h"
#include "ArcRelaxation.h"
#include "ArcWindows.h"
#include "SeamlessMapSolve.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "Separation.h"
#include "Support.h"
#include "TMeshPatches.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace crossfield::test
{
namespace
{
TMesh LinesOf(const PlanarDomain& domain, const Configuration& configuration, double meshSize)
{
  const SeamlessMap map =
    SolveSeamlessMap(ShareTopology(MeshOnPoints(domain, configuration, meshSize)), configuration);
  return MakeTMesh(map, TraceLines(map));
}

/// The least cost, at most `limit`, over all integers up to a largest one, with nothing joined that must not be, if asked.
double BruteForce(
  const TMesh& lines, const ArcProblem& problem, int largest, bool separate, double limit)
{
  double best = limit + 1e-6; // what costs more is not looked at
  std::vector<int> counts(problem.Count(), 0);
  std::vector<double> rest(problem.Count() + 1, 0.0); // what the arcs from one on cost at least
  for (std::size_t arc = problem.Count(); arc > 0; --arc)
  {
    const auto nearest = static_cast<int>(std::lround(problem.wanted[arc - 1]));
    rest[arc - 1] = rest[arc] + problem.Cost(arc - 1, nearest);
  }
  const std::function<void(std::size_t, double)> search = [&](std::size_t arc, double cost)
  {
    if (cost + rest[arc] >= best)
    {
      return;
    }
    if (arc == counts.size())
    {
      if (problem.Allows(counts) && (!separate || FindViolations(lines, counts).empty()))
      {
        best = cost;
      }
      return;
    }
    for (int n = 0; n <= largest; ++n)
    {
      counts[arc] = n;
      search(arc + 1, cost + problem.Cost(arc, n));
    }
    counts[arc] = 0;
  };
  search(0, 0.0);
  return best;
}

/// The flow with no number below `least`.
IntegerCounts FlowFrom(ArcProblem problem, int least)
{
  problem.lower.assign(problem.Count(), least);
  return SolveArcFlow(problem);
}

std::vector<int> AllArcs(const ArcProblem& problem)
{
  std::vector<int> all(problem.Count());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// A disk with four singularities of index 1, and pairs of ±1.
Configuration RandomPairs(Random& random, int pairs)
{
  Configuration configuration =
    OnCircle(4, random.Uniform(0.3, 0.5), random.Uniform(0.0, Pi), 1, 0.0);
  while (pairs > 0)
  {
    const Point place(random.Uniform(-0.8, 0.8), random.Uniform(-0.8, 0.8));
    const bool far = std::all_of(configuration.begin(), configuration.end(),
      [&place](const Singularity& other) { return (other.position - place).norm() > 0.15; });
    if (far && place.norm() < 0.85)
    {
      configuration.push_back({ place, configuration.size() % 2 == 0 ? 1 : -1 });
      pairs -= configuration.size() % 2 == 0 ? 1 : 0;
    }
  }
  return configuration;
}
}

TEST(ArcCounts, AreTheOptimumOfBruteForce)
{
  const std::vector<std::pair<PlanarDomain, Configuration>> cases = {
    { LShape(), {} },
    { RingOfEdges(0.2), {} },
    { MakePlanarDomain({ { { 0.0, 0.0 }, { 2.0, 0.0 }, { 0.8, 1.8 } } }), { { { 0.9, 0.6 }, 1 } } },
    { MakePlanarDomain({ RegularPolygon(5) }), { { { 0.05, 0.02 }, -1 } } },
  };
  for (const auto& [domain, configuration] : cases)
  {
    const TMesh lines = LinesOf(domain, configuration, 0.1);
    for (const double size : { 1.9, 1.3, 0.83 })
    {
      const ArcProblem problem = MakeArcProblem(lines, size);
      const IntegerCounts found = SolveArcFlow(problem);
      const int largest =
        2 + static_cast<int>(*std::max_element(problem.wanted.begin(), problem.wanted.end()));
      EXPECT_TRUE(problem.Allows(found.counts));
      EXPECT_TRUE(found.optimal);
      EXPECT_NEAR(found.cost, BruteForce(lines, problem, largest, false, found.cost), 1e-9);
      const ArcCounts counts = CountArcs(lines, problem, ArcSearch::Thorough);
      const double separated = BruteForce(lines, problem, largest + 1, true, counts.cost);
      EXPECT_TRUE(FindViolations(lines, counts.counts).empty());
      EXPECT_NEAR(counts.cost, separated, 1e-9);
      EXPECT_NEAR(counts.bound, separated, 1e-9);
      EXPECT_TRUE(counts.optimal);
    }
  }
}

/// A row that keeps points apart does not hold for the counts that joined them, and holds for lengths in the map, where
/// they are apart; with rows the optimum is proved, and no cheaper than that of the flow.
TEST(ArcCounts, KeepApartWhatIsApartInTheMap)
{
  Random random(4711);
  int rows = 0;
  for (int sample = 0; sample < 6; ++sample)
  {
    const Configuration configuration = RandomPairs(random, 2 + sample);
    const TMesh lines = LinesOf(DiskOfEdges(0.1), configuration, 0.06);
    for (const double size : { 0.4, 0.2, 0.1 })
    {
      SCOPED_TRACE(std::to_string(sample) + " " + std::to_string(size));
      const ArcProblem problem = MakeArcProblem(lines, size);
      const IntegerCounts joined = SolveArcFlow(problem);
      for (const Violation& violation : FindViolations(lines, joined.counts))
      {
        const ArcRow row = RowOf(violation, lines, joined.counts, problem.wanted);
        ASSERT_FALSE(row.terms.empty());
        EXPECT_FALSE(row.Holds(joined.counts));
        double apart = 0.0;
        for (const auto& [arc, factor] : row.terms)
        {
          apart += factor * problem.wanted[static_cast<std::size_t>(arc)];
        }
        EXPECT_GT(apart, 0.0);
        ++rows;
      }
      const ArcCounts counts = CountArcs(lines, problem, ArcSearch::Thorough);
      EXPECT_TRUE(problem.Allows(counts.counts));
      EXPECT_TRUE(FindViolations(lines, counts.counts).empty());
      EXPECT_TRUE(counts.optimal);
      EXPECT_GE(counts.bound, joined.bound - 1e-9);
      EXPECT_NEAR(counts.cost, problem.Cost(counts.counts), 1e-9 * (1.0 + counts.cost));
      const ArcCounts quick = CountArcs(lines, problem, ArcSearch::Quick);
      EXPECT_TRUE(FindViolations(lines, quick.counts).empty());
      EXPECT_GE(quick.cost, counts.cost - 1e-9 * (1.0 + counts.cost));
      EXPECT_LE(quick.bound, counts.cost + 1e-9 * (1.0 + counts.cost));
    }
  }
  EXPECT_GT(rows, 20);
}

/// Numbers of window after window stay a solution that joins nothing, never cost more, and come near to what is proved for all.
TEST(ArcWindows, LeadToTheOptimum)
{
  Random random(1234);
  double whole = 0.0;
  double windows = 0.0;
  double first = 0.0;
  std::size_t kept = 0;
  for (int sample = 0; sample < 2; ++sample)
  {
    SCOPED_TRACE(sample);
    const TMesh lines = LinesOf(DiskOfEdges(0.1), RandomPairs(random, 20), 0.06);
    const ArcProblem problem = MakeArcProblem(lines, 0.12);
    IntegerCounts found = FlowFrom(problem, 1);
    std::vector<ArcRow> rows;
    double cost = found.cost;
    first += cost;
    for (const std::size_t largest : { 0, 60, 100 })
    {
      ImproveInWindows(lines, problem, largest, found, rows);
      EXPECT_TRUE(problem.Allows(found.counts));
      EXPECT_TRUE(FindViolations(lines, found.counts).empty());
      EXPECT_NEAR(found.cost, problem.Cost(found.counts), CostRounding(cost));
      EXPECT_LE(found.cost, cost);
      cost = found.cost;
    }
    kept += rows.size();
    const ArcCounts best = CountArcs(lines, problem, ArcSearch::Thorough);
    EXPECT_TRUE(best.optimal);
    whole += best.cost;
    windows += cost;
  }
  EXPECT_GT(kept, 0u);
  EXPECT_GE(windows, whole);
  EXPECT_LT(windows, 2.0 * whole);
  EXPECT_GT(first, 2.0 * windows);
}

/// Cuts raise the bound, and never above the cost of whole numbers for which the rows hold.
TEST(ArcRelaxation, CutsOffNoWholeNumbers)
{
  Random random(99);
  double raised = 0.0;
  for (int sample = 0; sample < 3; ++sample)
  {
    SCOPED_TRACE(sample);
    const TMesh lines = LinesOf(DiskOfEdges(0.1), RandomPairs(random, 14), 0.06);
    const ArcProblem problem = MakeArcProblem(lines, 0.12);
    IntegerCounts found = FlowFrom(problem, 1);
    std::vector<ArcRow> rows;
    ImproveInWindows(lines, problem, 100, found, rows);
    const std::vector<int> all = AllArcs(problem);
    ImproveCounts(lines, problem, all, 1000, found, rows);
    ArcRelaxation relaxation(problem, all, found.counts);
    for (const ArcRow& row : rows)
    {
      if (row.Holds(found.counts))
      {
        relaxation.Add(row);
      }
    }
    ASSERT_EQ(relaxation.Solve(), RelaxationStatus::Optimal);
    const double first = relaxation.GetCost();
    double cost = first;
    for (int round = 0; round < 10 && relaxation.Cut(); ++round)
    {
      ASSERT_EQ(relaxation.Solve(), RelaxationStatus::Optimal);
      EXPECT_GE(relaxation.GetCost(), cost - CostRounding(cost));
      cost = relaxation.GetCost();
      EXPECT_LE(cost, found.cost + CostRounding(found.cost));
    }
    raised += cost - first;
  }
  EXPECT_GT(raised, 1.0);
}

/// With some arcs free the others stay, the equations hold, and nothing better is left among the free ones.
TEST(ArcProgram, LeavesWhatIsNotFree)
{
  const TMesh lines = LinesOf(LShape(), { { { 0.5, 0.5 }, 1 }, { { 1.4, 0.4 }, -1 } }, 0.1);
  const ArcProblem problem = MakeArcProblem(lines, 0.31);
  const std::vector<int> start = FlowFrom(problem, 2).counts;
  const std::vector<int> all = AllArcs(problem);
  const std::vector<int> some(
    all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2));
  const auto nothingJoined = [](const std::vector<int>&) { return std::vector<ArcRow>(); };
  const ProgramCounts inHalf = ArcProgram(problem, some, start).Solve(1000, nothingJoined);
  EXPECT_TRUE(problem.Allows(inHalf.counts));
  EXPECT_TRUE(std::equal(inHalf.counts.begin() + static_cast<std::ptrdiff_t>(some.size()),
    inHalf.counts.end(), start.begin() + static_cast<std::ptrdiff_t>(some.size())));
  EXPECT_LE(inHalf.cost, problem.Cost(start) + CostRounding(inHalf.cost));
  EXPECT_NEAR(inHalf.cost, problem.Cost(inHalf.counts), CostRounding(inHalf.cost));
  const ProgramCounts inAll = ArcProgram(problem, all, start).Solve(1000, nothingJoined);
  EXPECT_NEAR(inAll.cost, SolveArcFlow(problem).cost, CostRounding(inAll.cost));
  EXPECT_LE(inAll.cost, inHalf.cost + CostRounding(inHalf.cost));
}
}
