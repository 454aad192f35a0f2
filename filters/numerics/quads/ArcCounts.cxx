#include "ArcCounts.h"

#include "ArcFlow.h"
#include "Error.h"
#include "Separation.h"
#include "Stopwatch.h"

#include <algorithm>
#include <limits>

namespace crossfield
{
namespace
{
std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}

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
}

ArcCounts CountArcs(const TMesh& mesh, ArcProblem problem, const Progress& progress)
{
  Stopwatch stopwatch;
  ArcCounts result;
  IntegerCounts solution = SolveArcFlow(problem);
  const double bound = solution.bound;
  result.flows = solution.flows;
  bool proved = solution.optimal;
  for (std::vector<Violation> violations = FindViolations(mesh, solution.counts);
       !violations.empty(); violations = FindViolations(mesh, solution.counts))
  {
    progress.Report(0.2);
    proved = false;
    for (const Violation& violation : violations)
    {
      result.flows += Tighten(problem, solution.counts, violation);
    }
    solution = SolveArcFlow(problem);
    result.flows += solution.flows;
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
    result.flows += better.flows;
    if (FindViolations(mesh, better.counts).empty())
    {
      problem = std::move(without);
      solution = std::move(better);
    }
  }
  result.forced = static_cast<int>(
    std::count_if(problem.lower.begin(), problem.lower.end(), [](int lower) { return lower > 0; }));
  result.counts = solution.counts;
  result.zeroArcs = static_cast<int>(std::count(solution.counts.begin(), solution.counts.end(), 0));
  result.cost = solution.cost;
  result.bound = bound;
  const double rounding = 1e-9 * (1.0 + bound);
  result.gap = std::max(0.0, (solution.cost - bound) / (1.0 + bound));
  result.optimal = proved || solution.cost <= bound + rounding;
  result.gap = result.optimal ? 0.0 : result.gap;
  result.seconds = stopwatch.Lap();
  return result;
}
}
