#include "Quantisation.h"

#include "BidirectedFlow.h"
#include "BranchAndCut.h"
#include "Error.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"
#include "Relaxation.h"
#include "RepeatedEdges.h"
#include "SeamlessMapSolve.h"
#include "Separation.h"
#include "SizeSearch.h"
#include "Subproblem.h"
#include "Support.h"
#include "TMeshPatches.h"
#include "WindowSearch.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>

namespace crossfield::test
{
namespace
{
TMesh TMeshOf(const PlanarDomain& domain, const Configuration& configuration, double meshSize)
{
  const SeamlessMap map = SolveSeamlessMap(
    ShareTopology(MeshThroughPoints(domain, configuration, meshSize)), configuration);
  return MakeTMesh(map, TraceSeparatrices(map));
}

/// Returns the minimum cost, at most `limit`, over all integer counts up to `largest`, with
/// separation constraints if `separate` is set.
double BruteForce(
  const TMesh& mesh, const QuantisationProblem& problem, int largest, bool separate, double limit)
{
  double best = limit + 1e-6; // larger costs are not searched
  std::vector<int> counts(problem.Count(), 0);
  std::vector<double> rest(problem.Count() + 1, 0.0); // minimum cost of the arcs from one on
  for (std::size_t arc = problem.Count(); arc > 0; --arc)
  {
    const auto nearest = static_cast<int>(std::lround(problem.target[arc - 1]));
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
      if (problem.IsFeasible(counts) && (!separate || FindViolations(mesh, counts).empty()))
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

/// Returns the flow with at least `minimum` edges on every arc.
EdgeCounts FlowFrom(QuantisationProblem problem, int minimum)
{
  problem.lower.assign(problem.Count(), minimum);
  return SolveBidirectedFlow(problem);
}

std::vector<int> AllArcs(const QuantisationProblem& problem)
{
  std::vector<int> all(problem.Count());
  std::iota(all.begin(), all.end(), 0);
  return all;
}

/// Returns four singularities of index 1 and random pairs of ±1 in the unit disk.
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

TEST(Quantisation, AgreesWithBruteForce)
{
  const std::vector<std::pair<PlanarDomain, Configuration>> cases = {
    { LShape(), {} },
    { RingOfEdges(0.2), {} },
    { MakePlanarDomain({ { { 0.0, 0.0 }, { 2.0, 0.0 }, { 0.8, 1.8 } } }), { { { 0.9, 0.6 }, 1 } } },
    { MakePlanarDomain({ RegularPolygon(5) }), { { { 0.05, 0.02 }, -1 } } },
  };
  for (const auto& [domain, configuration] : cases)
  {
    const TMesh mesh = TMeshOf(domain, configuration, 0.1);
    for (const double size : { 1.9, 1.3, 0.83 })
    {
      const QuantisationProblem problem = MakeQuantisationProblem(mesh, size);
      const EdgeCounts found = SolveBidirectedFlow(problem);
      const int largest =
        2 + static_cast<int>(*std::max_element(problem.target.begin(), problem.target.end()));
      EXPECT_TRUE(problem.IsFeasible(found.counts));
      EXPECT_TRUE(found.optimal);
      EXPECT_NEAR(found.cost, BruteForce(mesh, problem, largest, false, found.cost), 1e-9);
      const EdgeCounts counts = Quantise(mesh, problem, SearchEffort::Thorough);
      const double separated = BruteForce(mesh, problem, largest + 1, true, counts.cost);
      EXPECT_TRUE(FindViolations(mesh, counts.counts).empty());
      EXPECT_NEAR(counts.cost, separated, 1e-9);
      EXPECT_NEAR(counts.bound, separated, 1e-9);
      EXPECT_TRUE(counts.optimal);
    }
  }
}

TEST(Quantisation, BalancedTargetsFulfilTheEquations)
{
  Random random(5);
  const TMesh meshes[] = { TMeshOf(LShape(), {}, 0.1), TMeshOf(RingOfEdges(0.2), {}, 0.1),
    TMeshOf(MakePlanarDomain({ { { 0.0, 0.0 }, { 2.0, 0.0 }, { 0.8, 1.8 } } }),
      { { { 0.9, 0.6 }, 1 } }, 0.1) };
  for (const TMesh& mesh : meshes)
  {
    QuantisationProblem problem = MakeQuantisationProblem(mesh, 0.1);
    const std::vector<double> consistent = problem.target;
    BalanceTargets(mesh, problem);
    for (std::size_t a = 0; a < problem.Count(); ++a)
    {
      EXPECT_NEAR(
        problem.target[a], consistent[a], 1e-2 * consistent[a]); // those of a map do already
    }
    for (double& target : problem.target)
    {
      target *= random.Uniform(0.5, 2.0);
    }
    BalanceTargets(mesh, problem);
    std::vector<double> sums(static_cast<std::size_t>(problem.equations), 0.0);
    double largest = 0.0;
    for (std::size_t a = 0; a < problem.Count(); ++a)
    {
      EXPECT_GE(problem.target[a], 0.0);
      largest = std::max(largest, problem.target[a]);
      for (const EquationTerm& term : problem.terms[a])
      {
        sums[static_cast<std::size_t>(term.equation)] += term.sign * problem.target[a];
      }
    }
    for (const double sum : sums)
    {
      EXPECT_NEAR(sum, 0.0, 2e-3 * largest);
    }
  }
}

TEST(Quantisation, BalancedTargetsOfAStripAreTheirGeometricMean)
{
  const TMesh mesh = TMeshOf(
    MakePlanarDomain({ { { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 0.0, 1.0 } } }), {}, 0.2);
  ASSERT_EQ(mesh.patches.size(), 1U);
  QuantisationProblem problem = MakeQuantisationProblem(mesh, 0.1);
  const auto arcOf = [&](std::size_t side)
  { return static_cast<std::size_t>(mesh.patches[0].sides[side][0] / 2); };
  problem.target[arcOf(0)] = 8.0;
  problem.target[arcOf(2)] = 18.0;
  problem.weight[arcOf(0)] = problem.weight[arcOf(2)];
  BalanceTargets(mesh, problem);
  EXPECT_NEAR(problem.target[arcOf(0)], 12.0, 1e-9);
  EXPECT_NEAR(problem.target[arcOf(2)], 12.0, 1e-9);
}

/// Equations of paired sides, here of random arcs of the boundary: nearly always the flow alone is optimal with
/// them, and Quantise is with separation. Where that is impossible, the message names the equation.
TEST(Quantisation, AgreesWithBruteForceForPairs)
{
  Random random(271828);
  const TMesh meshes[] = { TMeshOf(LShape(), {}, 0.1), TMeshOf(RingOfEdges(0.2), {}, 0.1),
    TMeshOf(MakePlanarDomain({ { { 0.0, 0.0 }, { 2.0, 0.0 }, { 0.8, 1.8 } } }),
      { { { 0.9, 0.6 }, 1 } }, 0.1) };
  int optimal = 0;
  int byFlow = 0;
  int impossible = 0;
  int pairs = 0;
  for (int trial = 0; trial < 72; ++trial)
  {
    SCOPED_TRACE(trial);
    const TMesh& mesh = meshes[trial % 3];
    QuantisationProblem problem = MakeQuantisationProblem(mesh, random.Uniform(0.6, 1.4));
    CountSum pair;
    pair.name = "The pair";
    int sign = 0;
    for (std::size_t a = 0; a < mesh.arcs.size(); ++a)
    {
      const int side = random.Integer(0, 3);
      if (mesh.arcs[a].onBoundary && side < 2)
      {
        pair.terms.emplace_back(static_cast<int>(a), 2 * side - 1);
        sign += 2 * side - 1;
      }
    }
    if (std::abs(sign) == static_cast<int>(pair.terms.size()))
    {
      continue; // no arcs on one side
    }
    ++pairs;
    const EdgeCounts without = SolveBidirectedFlow(problem);
    problem.sums = { pair };
    EXPECT_TRUE(WithSumsAsEquations(problem).sums.empty());
    const EdgeCounts flow = SolveBidirectedFlow(WithSumsAsEquations(problem));
    const int largest =
      2 + static_cast<int>(*std::max_element(problem.target.begin(), problem.target.end()));
    ASSERT_TRUE(problem.IsFeasible(flow.counts));
    const double joined = BruteForce(mesh, problem, largest, false, flow.cost);
    EXPECT_LE(flow.bound, joined + 1e-9);
    if (flow.optimal)
    {
      EXPECT_NEAR(flow.cost, joined, 1e-9);
      ++optimal;
    }
    try
    {
      const EdgeCounts counts = Quantise(mesh, problem, SearchEffort::Thorough);
      EXPECT_TRUE(problem.IsFeasible(counts.counts));
      EXPECT_TRUE(FindViolations(mesh, counts.counts).empty());
      EXPECT_TRUE(counts.optimal);
      EXPECT_NEAR(counts.cost, BruteForce(mesh, problem, largest + 1, true, counts.cost), 1e-9);
      if (flow.optimal && FindViolations(mesh, flow.counts).empty() &&
        !problem.IsFeasible(without.counts))
      {
        EXPECT_EQ(counts.nodes, 0) << "of branch and cut";
        ++byFlow;
      }
    }
    catch (const Error& error)
    {
      ++impossible;
      EXPECT_EQ(
        std::string(error.what()), "The pair fits no mesh of these singularities; leave it out.");
      const double none = 1e3;
      EXPECT_GE(BruteForce(mesh, problem, 4, true, none), none);
    }
  }
  EXPECT_GT(optimal, 0.9 * pairs) << "flows; few need too many";
  EXPECT_GT(byFlow, 3) << "pairs that change the counts";
  EXPECT_GT(impossible, 5);
}

/// A separation row excludes the counts for which points coincide, and holds for the target counts.
/// With these rows the optimum is proved, and costs no less than the flow.
TEST(Quantisation, SeparatesPointsThatAreDistinctInTheMap)
{
  Random random(4711);
  int rows = 0;
  for (int sample = 0; sample < 6; ++sample)
  {
    const Configuration configuration = RandomPairs(random, 2 + sample);
    const TMesh mesh = TMeshOf(DiskOfEdges(0.1), configuration, 0.06);
    for (const double size : { 0.4, 0.2, 0.1 })
    {
      SCOPED_TRACE(std::to_string(sample) + " " + std::to_string(size));
      const QuantisationProblem problem = MakeQuantisationProblem(mesh, size);
      const EdgeCounts joined = SolveBidirectedFlow(problem);
      for (const Violation& violation : FindViolations(mesh, joined.counts))
      {
        const SeparationRow row = MakeSeparationRow(violation, mesh, joined.counts, problem.target);
        ASSERT_FALSE(row.terms.empty());
        EXPECT_FALSE(row.Holds(joined.counts));
        double apart = 0.0;
        for (const auto& [arc, factor] : row.terms)
        {
          apart += factor * problem.target[static_cast<std::size_t>(arc)];
        }
        EXPECT_GT(apart, 0.0);
        ++rows;
      }
      const EdgeCounts counts = Quantise(mesh, problem, SearchEffort::Thorough);
      EXPECT_TRUE(problem.IsFeasible(counts.counts));
      EXPECT_TRUE(FindViolations(mesh, counts.counts).empty());
      EXPECT_TRUE(counts.optimal);
      EXPECT_GE(counts.bound, joined.bound - 1e-9);
      EXPECT_NEAR(counts.cost, problem.Cost(counts.counts), 1e-9 * (1.0 + counts.cost));
      const EdgeCounts quick = Quantise(mesh, problem, SearchEffort::Quick);
      EXPECT_TRUE(FindViolations(mesh, quick.counts).empty());
      EXPECT_GE(quick.cost, counts.cost - 1e-9 * (1.0 + counts.cost));
      EXPECT_LE(quick.bound, counts.cost + 1e-9 * (1.0 + counts.cost));
    }
  }
  EXPECT_GT(rows, 20);
}

/// Lower bounds of counts hold in branch and cut as in flows.
TEST(Quantisation, KeepsLowerBounds)
{
  Random random(59);
  int raised = 0;
  for (int sample = 0; sample < 12; ++sample)
  {
    SCOPED_TRACE(sample);
    const TMesh mesh = TMeshOf(DiskOfEdges(0.15), RandomPairs(random, 1), 0.1);
    QuantisationProblem problem = MakeQuantisationProblem(mesh, 0.9);
    const EdgeCounts without = Quantise(mesh, problem, SearchEffort::Thorough);
    for (std::size_t a = 0; a < problem.Count(); a += 3)
    {
      problem.lower[a] = 2;
    }
    const EdgeCounts counts = Quantise(mesh, problem, SearchEffort::Thorough);
    EXPECT_TRUE(problem.IsFeasible(counts.counts));
    EXPECT_TRUE(FindViolations(mesh, counts.counts).empty());
    EXPECT_LE(counts.bound, counts.cost + CostRounding(counts.cost));
    EXPECT_GE(counts.cost, without.cost - CostRounding(without.cost));
    raised += problem.IsFeasible(without.counts) ? 0 : 1;
    // Windows of all arcs: branch and cut alone.
    std::vector<int> all(problem.Count());
    std::iota(all.begin(), all.end(), 0);
    const EdgeCounts free =
      BranchAndCut(problem, all, {})
        .Solve({ 100 }, [](const std::vector<int>&) { return std::vector<SeparationRow>(); });
    ASSERT_FALSE(free.counts.empty());
    EXPECT_TRUE(problem.IsFeasible(free.counts));
    EXPECT_NEAR(free.cost, problem.Cost(free.counts), CostRounding(free.cost));
  }
  EXPECT_GT(raised, 6);
}

/// A search that starts with the counts of another size is as good as one from nothing.
TEST(Quantisation, ContinuesFromAnotherSize)
{
  Random random(812);
  for (int sample = 0; sample < 4; ++sample)
  {
    SCOPED_TRACE(sample);
    const TMesh mesh = TMeshOf(DiskOfEdges(0.1), RandomPairs(random, 6), 0.06);
    KnownCounts known;
    for (const double size : { 0.2, 0.25, 0.3 })
    {
      const QuantisationProblem problem = MakeQuantisationProblem(mesh, size);
      const EdgeCounts alone = Quantise(mesh, problem, SearchEffort::Thorough);
      const EdgeCounts next = Quantise(mesh, problem, SearchEffort::Thorough, &known);
      EXPECT_TRUE(problem.IsFeasible(next.counts));
      EXPECT_TRUE(FindViolations(mesh, next.counts).empty());
      EXPECT_EQ(known.counts, next.counts);
      EXPECT_LE(next.cost, 1.01 * alone.cost + CostRounding(alone.cost));
    }
  }
}

/// Only arcs that are two edges between the same points are repeated, not those on both sides of a patch of zero
/// Sizes that are tried by estimates give the requested number of quads with few solutions, also if all estimates are
/// too large, and the same counts every time.
TEST(SizeSearch, TriesSizesByEstimates)
{
  Random random(31);
  int estimates = 0;
  for (int sample = 0; sample < 3; ++sample)
  {
    SCOPED_TRACE(sample);
    const TMesh mesh = TMeshOf(DiskOfEdges(0.1), RandomPairs(random, 14), 0.06);
    std::vector<double> lengths;
    for (const TArc& arc : mesh.arcs)
    {
      lengths.push_back(arc.length);
    }
    const double area = CountQuads(mesh, lengths);
    constexpr int Requested = 400;
    int solutions = 0;
    const auto search = [&](double factor)
    {
      KnownCounts known;
      solutions = 0;
      return SearchCountsByEstimates(
        mesh, Requested, area,
        [&](double size, SearchEffort effort)
        {
          ++solutions;
          EdgeCounts counts = Quantise(mesh, MakeQuantisationProblem(mesh, size), effort, &known);
          counts.optimal = false; // as of a problem that takes long
          return counts;
        },
        [&](double size)
        {
          ++estimates;
          return factor * CountQuads(mesh, RelaxCounts(MakeQuantisationProblem(mesh, size), known));
        });
    };
    const EdgeCounts found = search(1.0);
    EXPECT_LE(CountError(mesh, found, Requested), CountTolerance);
    EXPECT_TRUE(MakeQuantisationProblem(mesh, found.size).IsFeasible(found.counts));
    EXPECT_TRUE(FindViolations(mesh, found.counts).empty());
    EXPECT_LE(solutions, 4);
    EXPECT_EQ(search(1.0).counts, found.counts);
    EXPECT_LE(CountError(mesh, search(1.3), Requested), CountTolerance);
  }
  EXPECT_GT(estimates, 0);
}

/// The relaxation with the rows that a search has found costs at most as much as its counts, and more than without them.
TEST(Quantisation, RelaxesWithKnownRows)
{
  Random random(32);
  const TMesh mesh = TMeshOf(DiskOfEdges(0.1), RandomPairs(random, 14), 0.06);
  KnownCounts known;
  Quantise(mesh, MakeQuantisationProblem(mesh, 0.1), SearchEffort::Thorough, &known);
  ASSERT_FALSE(known.rows.empty());
  const QuantisationProblem problem = MakeQuantisationProblem(mesh, 0.12);
  const EdgeCounts next = Quantise(mesh, problem, SearchEffort::Thorough, &known);
  const auto costOf = [&problem](const std::vector<double>& counts)
  {
    double cost = 0.0;
    for (std::size_t a = 0; a < problem.Count(); ++a)
    {
      cost += problem.weight[a] * std::abs(counts[a] - problem.target[a]);
    }
    return cost;
  };
  const double cost = costOf(RelaxCounts(problem, known));
  EXPECT_LE(cost, next.cost + CostRounding(next.cost));
  EXPECT_GT(cost, costOf(RelaxCounts(problem, {})));
}

/// Rounds of cuts that raise the bound by little may be left out; the bound stays one.
TEST(BranchAndCut, EndsRoundsOfCutsThatRaiseTheBoundByLittle)
{
  Random random(99);
  const TMesh mesh = TMeshOf(DiskOfEdges(0.1), RandomPairs(random, 14), 0.06);
  const QuantisationProblem problem = MakeQuantisationProblem(mesh, 0.12);
  EdgeCounts start = FlowFrom(problem, 1);
  std::vector<SeparationRow> rows;
  ImproveInWindows(mesh, problem, 100, start, rows);
  const EdgeCounts best = Quantise(mesh, problem, SearchEffort::Thorough);
  const std::vector<int> all = AllArcs(problem);
  const auto boundWith = [&](double minimumRise)
  {
    std::vector<SeparationRow> used = rows;
    return SolveSubproblem(mesh, problem, all, { 20, minimumRise }, start, used).bound;
  };
  EXPECT_LE(boundWith(0.01), best.cost + CostRounding(best.cost));
  EXPECT_LE(boundWith(0.0), best.cost + CostRounding(best.cost));
}

/// width.
TEST(RepeatedEdges, AreDifferentEdges)
{
  Random random(7);
  int zero = 0;
  for (int sample = 0; sample < 6; ++sample)
  {
    const TMesh mesh = TMeshOf(DiskOfEdges(0.1), RandomPairs(random, 4), 0.06);
    for (const double size : { 0.5, 0.3 })
    {
      const EdgeCounts counts =
        Quantise(mesh, MakeQuantisationProblem(mesh, size), SearchEffort::Quick);
      zero += static_cast<int>(std::count(counts.counts.begin(), counts.counts.end(), 0));
      EXPECT_TRUE(FindRepeatedEdges(mesh, counts.counts).empty()); // quads of a disk have none
    }
  }
  EXPECT_GT(zero, 20);
}

/// Counts stay feasible after every window, never cost more, and come near to the proved optimum.
TEST(WindowSearch, ApproachesTheOptimum)
{
  Random random(1234);
  double optima = 0.0;
  double windows = 0.0;
  double first = 0.0;
  std::size_t kept = 0;
  for (int sample = 0; sample < 2; ++sample)
  {
    SCOPED_TRACE(sample);
    const TMesh mesh = TMeshOf(DiskOfEdges(0.1), RandomPairs(random, 20), 0.06);
    const QuantisationProblem problem = MakeQuantisationProblem(mesh, 0.12);
    EdgeCounts found = FlowFrom(problem, 1);
    std::vector<SeparationRow> rows;
    double cost = found.cost;
    first += cost;
    for (const std::size_t largest : { 0, 60, 100 })
    {
      ImproveInWindows(mesh, problem, largest, found, rows);
      EXPECT_TRUE(problem.IsFeasible(found.counts));
      EXPECT_TRUE(FindViolations(mesh, found.counts).empty());
      EXPECT_NEAR(found.cost, problem.Cost(found.counts), CostRounding(cost));
      EXPECT_LE(found.cost, cost);
      cost = found.cost;
    }
    kept += rows.size();
    const EdgeCounts best = Quantise(mesh, problem, SearchEffort::Thorough);
    EXPECT_TRUE(best.optimal);
    optima += best.cost;
    windows += cost;
  }
  EXPECT_GT(kept, 0u);
  EXPECT_GE(windows, optima);
  EXPECT_LT(windows, 2.0 * optima);
  EXPECT_GT(first, 2.0 * windows);
}

/// Cuts raise the bound, but never above the cost of integer counts that satisfy the rows.
TEST(Relaxation, CutsKeepIntegerSolutions)
{
  Random random(99);
  double raised = 0.0;
  for (int sample = 0; sample < 3; ++sample)
  {
    SCOPED_TRACE(sample);
    const TMesh mesh = TMeshOf(DiskOfEdges(0.1), RandomPairs(random, 14), 0.06);
    const QuantisationProblem problem = MakeQuantisationProblem(mesh, 0.12);
    EdgeCounts found = FlowFrom(problem, 1);
    std::vector<SeparationRow> rows;
    ImproveInWindows(mesh, problem, 100, found, rows);
    const std::vector<int> all = AllArcs(problem);
    ReplaceIfCheaper(found, SolveSubproblem(mesh, problem, all, { 1000 }, found, rows));
    Relaxation relaxation(problem, all, found.counts);
    for (const SeparationRow& row : rows)
    {
      if (row.Holds(found.counts))
      {
        relaxation.AddRow(row);
      }
    }
    ASSERT_EQ(relaxation.Solve(), SolveStatus::Optimal);
    const double first = relaxation.GetCost();
    double cost = first;
    for (int round = 0; round < 10 && relaxation.AddCuts(); ++round)
    {
      ASSERT_EQ(relaxation.Solve(), SolveStatus::Optimal);
      EXPECT_GE(relaxation.GetCost(), cost - CostRounding(cost));
      cost = relaxation.GetCost();
      EXPECT_LE(cost, found.cost + CostRounding(found.cost));
    }
    raised += cost - first;
  }
  EXPECT_GT(raised, 1.0);
}

/// Bounds remain possible when the optimum of the root becomes the best solution, whose cost is above the
/// cutoff by rounding, and some reduced costs are hardly more than 0.
TEST(Relaxation, TightensBoundsAtTheCutoff)
{
  Random random(100);
  const TMesh mesh = TMeshOf(DiskOfEdges(0.1), RandomPairs(random, 6), 0.06);
  QuantisationProblem problem = MakeQuantisationProblem(mesh, 0.3);
  for (double& weight : problem.weight)
  {
    weight = 1.0 + random.Uniform(0.0, 1e-4);
  }
  Relaxation relaxation(problem, AllArcs(problem), {});
  ASSERT_EQ(relaxation.Solve(), SolveStatus::Optimal);
  const double cost = relaxation.GetCost();
  relaxation.SetCutoff(cost - CostRounding(cost));
  relaxation.TightenBounds();
  relaxation.SetCutoff(2.0 * cost + 1.0);
  ASSERT_EQ(relaxation.Solve(), SolveStatus::Optimal);
  EXPECT_NEAR(relaxation.GetCost(), cost, CostRounding(cost));
  for (const int arc : AllArcs(problem))
  {
    EXPECT_GE(relaxation.GetCount(arc), -1e-6);
  }
}

/// Arcs that are not free keep their counts, and the equations hold. With all arcs free, the result
/// equals the flow.
TEST(BranchAndCut, KeepsArcsThatAreNotFree)
{
  const TMesh mesh = TMeshOf(LShape(), { { { 0.5, 0.5 }, 1 }, { { 1.4, 0.4 }, -1 } }, 0.1);
  const QuantisationProblem problem = MakeQuantisationProblem(mesh, 0.31);
  const std::vector<int> start = FlowFrom(problem, 2).counts;
  const std::vector<int> all = AllArcs(problem);
  const std::vector<int> some(
    all.begin(), all.begin() + static_cast<std::ptrdiff_t>(all.size() / 2));
  const auto isSeparated = [](const std::vector<int>&) { return std::vector<SeparationRow>(); };
  const EdgeCounts inHalf = BranchAndCut(problem, some, start).Solve({ 1000 }, isSeparated);
  EXPECT_TRUE(problem.IsFeasible(inHalf.counts));
  EXPECT_TRUE(std::equal(inHalf.counts.begin() + static_cast<std::ptrdiff_t>(some.size()),
    inHalf.counts.end(), start.begin() + static_cast<std::ptrdiff_t>(some.size())));
  EXPECT_LE(inHalf.cost, problem.Cost(start) + CostRounding(inHalf.cost));
  EXPECT_NEAR(inHalf.cost, problem.Cost(inHalf.counts), CostRounding(inHalf.cost));
  const EdgeCounts inAll = BranchAndCut(problem, all, start).Solve({ 1000 }, isSeparated);
  EXPECT_NEAR(inAll.cost, SolveBidirectedFlow(problem).cost, CostRounding(inAll.cost));
  EXPECT_LE(inAll.cost, inHalf.cost + CostRounding(inHalf.cost));
}
}
