#include "ArcCounts.h"

#include "ArcFlow.h"
#include "ArcProgram.h"
#include "ArcWindows.h"
#include "Separation.h"
#include "Stopwatch.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
/// Of the cost, before everything is apart: rows are still to come.
constexpr double RoughGap = 0.01;
/// Of the nodes, for each solution before everything is apart.
constexpr int RoughRounds = 6;

/// One edge or more everywhere, and three around every loop: nothing is joined.
IntegerCounts KeepAllArcs(const TMesh& mesh, ArcProblem problem)
{
  problem.lower.assign(problem.Count(), 1);
  IntegerCounts kept = SolveArcFlow(problem);
  const std::vector<Violation> shortLoops = FindViolations(mesh, kept.counts);
  for (const Violation& loop : shortLoops)
  {
    for (const int arc : loop.arcs)
    {
      problem.lower[static_cast<std::size_t>(arc)] = LeastLoop;
    }
  }
  return shortLoops.empty() ? kept : SolveArcFlow(problem);
}

/// Arcs of the largest windows.
constexpr std::size_t QuickWindow = 100;
constexpr std::size_t ThoroughWindow = 300;

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

/// Adds rows for what is one and must not be, and solves again, as long as nodes are left: roughly until counts
/// keep everything apart, then to the optimum. Better counts than those given, if it finds them, and a better bound.
void AddRows(const TMesh& mesh, const ArcProblem& problem, std::vector<int> counts,
  const std::vector<ArcRow>& rows, int most, ArcCounts& best, const Progress& progress)
{
  if (most < RoughRounds)
  {
    return;
  }
  int nodes = most;
  double gap = RoughGap;
  ArcProgram program(problem);
  for (const ArcRow& row : rows)
  {
    if (row.Holds(best.counts))
    {
      program.Add(row);
    }
  }
  while (nodes > 0)
  {
    progress.Report(1.0 - static_cast<double>(nodes) / most);
    const std::vector<Violation> violations = FindViolations(mesh, counts);
    for (const Violation& violation : violations)
    {
      program.Add(RowAllowing(best.counts, violation, mesh, counts, problem.wanted));
    }
    if (violations.empty())
    {
      const double cost = problem.Cost(counts);
      if (cost < best.cost - CostRounding(best.bound))
      {
        best.counts = counts;
        best.cost = cost;
      }
      if (gap == 0.0 || best.cost <= best.bound + CostRounding(best.bound))
      {
        return;
      }
      gap = 0.0;
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
}
}

ArcCounts CountArcs(
  const TMesh& mesh, const ArcProblem& problem, ArcSearch search, const Progress& progress)
{
  Stopwatch stopwatch;
  const IntegerCounts joined = SolveArcFlow(problem);
  ArcCounts result;
  result.bound = joined.optimal ? joined.cost : joined.bound;
  IntegerCounts apart = joined;
  std::vector<ArcRow> rows;
  if (!FindViolations(mesh, joined.counts).empty())
  {
    apart = KeepAllArcs(mesh, problem);
    ImproveInWindows(mesh, problem, search == ArcSearch::Quick ? QuickWindow : ThoroughWindow,
      apart, rows, progress.Part(0.0, 0.5));
  }
  result.counts = std::move(apart.counts);
  result.cost = apart.cost;
  if (result.cost > result.bound + CostRounding(result.bound))
  {
    AddRows(mesh, problem, joined.counts, rows, NodesFor(problem, search), result,
      progress.Part(0.5, 1.0));
  }
  result.zeroArcs = static_cast<int>(std::count(result.counts.begin(), result.counts.end(), 0));
  result.optimal = result.cost <= result.bound + CostRounding(result.bound);
  result.gap = result.optimal ? 0.0 : (result.cost - result.bound) / (1.0 + result.bound);
  result.seconds = stopwatch.Lap();
  return result;
}
}
