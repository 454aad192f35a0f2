#include "ArcCounts.h"

#include "ArcFlow.h"
#include "ArcProgram.h"
#include "Error.h"
#include "Separation.h"
#include "Stopwatch.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace crossfield
{
namespace
{
std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

/// Of costs, which are sums of products: far below what an edge more or less makes.
double Rounding(double cost)
{
  return 1e-9 * (1.0 + cost);
}

/// Of the cost, before everything is apart: rows are still to come.
constexpr double RoughGap = 0.01;
/// Of the nodes, for each solution before everything is apart.
constexpr int RoughRounds = 6;

/// Bounds the arc of a violation with which the cost rises least.
int Tighten(ArcProblem& problem, const std::vector<int>& counts, const Violation& violation)
{
  const std::vector<int> free(problem.Count(), -1);
  int best = -1;
  double least = std::numeric_limits<double>::infinity();
  int flows = 0;
  for (const int arc : violation.arcs)
  {
    std::vector<int> lower = problem.lower;
    lower[Index(arc)] = counts[Index(arc)] + 1;
    const RelaxedCounts relaxed = SolveRelaxedCounts(problem, lower, free);
    ++flows;
    if (relaxed.feasible && relaxed.cost < least)
    {
      least = relaxed.cost;
      best = arc;
    }
  }
  if (best < 0)
  {
    throw Error("Two singularities cannot be kept apart by quads; use a smaller size.");
  }
  problem.lower[Index(best)] = std::max(problem.lower[Index(best)], counts[Index(best)] + 1);
  return flows;
}

/// Bounds arcs until nothing is one that must not be; then drops the bounds that are not needed.
IntegerCounts BoundArcs(
  const TMesh& mesh, ArcProblem problem, IntegerCounts solution, const Progress& progress)
{
  int flows = solution.flows;
  for (std::vector<Violation> violations = FindViolations(mesh, solution.counts);
       !violations.empty(); violations = FindViolations(mesh, solution.counts))
  {
    progress.Report(0.2);
    for (const Violation& violation : violations)
    {
      flows += Tighten(problem, solution.counts, violation);
    }
    solution = SolveArcFlow(problem);
    flows += solution.flows;
  }
  // Later bounds may have made earlier ones superfluous.
  for (std::size_t a = 0; a < problem.Count(); ++a)
  {
    if (problem.lower[a] == 0)
    {
      continue;
    }
    progress.Report(0.2 + 0.8 * static_cast<double>(a) / static_cast<double>(problem.Count()));
    ArcProblem without = problem;
    --without.lower[a];
    IntegerCounts better = SolveArcFlow(without);
    flows += better.flows;
    if (FindViolations(mesh, better.counts).empty())
    {
      problem = std::move(without);
      solution = std::move(better);
    }
  }
  solution.flows = flows;
  return solution;
}

int NodesFor(const ArcProblem& problem, ArcSearch search)
{
  // Times arcs: five to ten seconds for the thorough one. Not seconds, so that numbers are the same on every machine.
  constexpr int ArcsTimesNodes = 150000;
  constexpr int QuickPart = 20;
  // What very many arcs get nevertheless.
  constexpr int LeastNodes = 50;
  const int nodes = ArcsTimesNodes / std::max(1, static_cast<int>(problem.Count()));
  return search == ArcSearch::Quick ? nodes / QuickPart : std::max(LeastNodes, nodes);
}

/// Takes counts that are better than the best.
void Take(const IntegerCounts& found, ArcCounts& best)
{
  best.flows += found.flows;
  if (found.cost < best.cost - Rounding(best.bound))
  {
    best.counts = found.counts;
    best.cost = found.cost;
  }
}

/// Adds rows for what is one and must not be, and solves again, as long as nodes are left: roughly until counts
/// keep everything apart, then to the optimum. Better counts than those given, if it finds them, and a better bound.
void AddRows(const TMesh& mesh, const ArcProblem& problem, std::vector<int> counts, int most,
  ArcCounts& best, const Progress& progress)
{
  if (most < RoughRounds)
  {
    return;
  }
  int nodes = most;
  double gap = RoughGap;
  ArcProgram program(problem);
  while (nodes > 0)
  {
    progress.Report(1.0 - static_cast<double>(nodes) / most);
    const std::vector<Violation> violations = FindViolations(mesh, counts);
    for (const Violation& violation : violations)
    {
      const ArcRow row = RowOf(violation, mesh, counts, problem.wanted);
      if (row.terms.empty() || row.Holds(counts))
      {
        nodes = 0; // there is no row for it
        break;
      }
      program.Add(row);
    }
    if (violations.empty())
    {
      Take({ counts, problem.Cost(counts) }, best);
      if (gap == 0.0 || best.cost <= best.bound + Rounding(best.bound))
      {
        return;
      }
      gap = 0.0;
    }
    if (nodes == 0)
    {
      break;
    }
    ProgramCounts found =
      program.Solve(best.counts, gap > 0.0 ? std::min(nodes, most / RoughRounds) : nodes, gap);
    nodes -= std::max(1, found.nodes);
    best.nodes += found.nodes;
    best.bound = std::max(best.bound, found.bound);
    if (found.counts.empty())
    {
      break;
    }
    counts = std::move(found.counts);
  }
  // What is apart stays so, what is not gets bounds.
  ArcProblem repaired = problem;
  for (std::size_t a = 0; a < problem.Count(); ++a)
  {
    repaired.lower[a] = std::min(counts[a], 1);
  }
  IntegerCounts start;
  start.counts = std::move(counts);
  start.cost = problem.Cost(start.counts);
  Take(BoundArcs(mesh, std::move(repaired), std::move(start), {}), best);
}
}

ArcCounts CountArcs(
  const TMesh& mesh, const ArcProblem& problem, ArcSearch search, const Progress& progress)
{
  Stopwatch stopwatch;
  const IntegerCounts joined = SolveArcFlow(problem);
  IntegerCounts apart = BoundArcs(mesh, problem, joined, progress.Part(0.0, 0.5));
  ArcCounts result;
  result.flows = apart.flows;
  result.counts = std::move(apart.counts);
  result.cost = apart.cost;
  result.bound = joined.optimal ? joined.cost : joined.bound;
  if (result.cost > result.bound + Rounding(result.bound))
  {
    AddRows(
      mesh, problem, joined.counts, NodesFor(problem, search), result, progress.Part(0.5, 1.0));
  }
  result.zeroArcs = static_cast<int>(std::count(result.counts.begin(), result.counts.end(), 0));
  result.optimal = result.cost <= result.bound + Rounding(result.bound);
  result.gap = result.optimal ? 0.0 : (result.cost - result.bound) / (1.0 + result.bound);
  result.seconds = stopwatch.Lap();
  return result;
}
}
