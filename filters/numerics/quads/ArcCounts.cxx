#include "ArcCounts.h"

#include "ArcImprovement.h"
#include "ArcWindows.h"
#include "Separation.h"
#include "Stopwatch.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
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

/// Of one search of the whole problem.
int NodesFor(const ArcProblem& problem, ArcSearch search)
{
  // Times arcs: a few seconds for the thorough one. Not seconds, so that numbers are the same on every machine.
  constexpr int ArcsTimesNodes = 250000;
  // What very many arcs get nevertheless.
  constexpr int LeastNodes = 300;
  constexpr int QuickPart = 20;
  const int nodes = std::max(LeastNodes, ArcsTimesNodes / static_cast<int>(problem.Count()));
  return search == ArcSearch::Quick ? nodes / QuickPart : nodes;
}

/// All arcs are free. The first search meets nearly all the rows; the second, if it is needed, has cuts of all of them
/// from the beginning.
void ImproveWhole(const TMesh& mesh, const ArcProblem& problem, int mostNodes, IntegerCounts& best,
  std::vector<ArcRow>& rows, ArcCounts& result, const Progress& progress)
{
  std::vector<int> all(problem.Count());
  std::iota(all.begin(), all.end(), 0);
  constexpr int Searches = 2;
  for (int i = 0; i < Searches && best.cost > result.bound + CostRounding(result.bound); ++i)
  {
    progress.Report(static_cast<double>(i) / Searches);
    const Improvement improvement = ImproveCounts(mesh, problem, all, mostNodes, best, rows);
    result.bound = std::max(result.bound, improvement.bound);
    result.nodes += improvement.nodes;
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
  ImproveWhole(
    mesh, problem, NodesFor(problem, search), apart, rows, result, progress.Part(0.5, 1.0));
  result.counts = std::move(apart.counts);
  result.cost = apart.cost;
  result.zeroArcs = static_cast<int>(std::count(result.counts.begin(), result.counts.end(), 0));
  result.optimal = result.cost <= result.bound + CostRounding(result.bound);
  result.gap = result.optimal ? 0.0 : (result.cost - result.bound) / (1.0 + result.bound);
  result.seconds = stopwatch.Lap();
  return result;
}
}
