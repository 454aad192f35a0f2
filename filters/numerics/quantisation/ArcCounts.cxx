#include "ArcCounts.h"

#include "ArcImprovement.h"
#include "ArcWindows.h"
#include "Index.h"
#include "Separation.h"
#include "Stopwatch.h"

#include <algorithm>
#include <cmath>
#include <iterator>
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

/// How far numbers are searched for.
struct Effort
{
  std::size_t window = 0; ///< Arcs of the largest.
  int nodes = 0;          ///< Of each search of the whole problem.
  int turns = 0;
};

Effort EffortFor(const ArcProblem& problem, ArcSearch search)
{
  // Times arcs: a second or two for a thorough turn. Not seconds, so that numbers are the same on every machine.
  constexpr int ArcsTimesNodes = 250000;
  // What very many arcs get nevertheless.
  constexpr int LeastNodes = 300;
  constexpr int QuickPart = 20;
  const int nodes = std::max(LeastNodes, ArcsTimesNodes / static_cast<int>(problem.Count()));
  return search == ArcSearch::Quick ? Effort{ 100, nodes / QuickPart, 1 } : Effort{ 200, nodes, 3 };
}

/// Windows, the whole problem, and what these differ in, in turns, until nothing finds better numbers.
class Turns
{
public:
  Turns(const TMesh& mesh, const ArcProblem& problem, const Effort& effort)
    : Mesh(mesh)
    , Problem(problem)
    , Most(effort)
    , All(problem.Count())
  {
    std::iota(this->All.begin(), this->All.end(), 0);
  }

  /// `result` has the bound of the flow.
  void Run(IntegerCounts& best, ArcCounts& result, const Progress& progress)
  {
    const double flow = result.bound;
    for (int turn = 0; turn < this->Most.turns; ++turn)
    {
      const Progress part = progress.Part(
        static_cast<double>(turn) / this->Most.turns, (turn + 1.0) / this->Most.turns);
      const double before = best.cost;
      this->SearchWindows(best, part.Part(0.0, 0.5));
      if (this->DropBroken(best.counts))
      {
        result.bound = flow;
      }
      const bool isProved = best.cost <= result.bound + CostRounding(result.bound);
      if (isProved && best.cost >= before)
      {
        return;
      }
      part.Report(0.5);
      const Improvement whole =
        ImproveCounts(this->Mesh, this->Problem, this->All, this->Most.nodes, best, this->Rows);
      result.bound = std::max(result.bound, whole.bound);
      result.nodes += whole.nodes;
      this->SearchDifferences(whole.relaxed, best);
    }
  }

private:
  /// With rows of their own, so that numbers that break those met before are found as well.
  void SearchWindows(IntegerCounts& best, const Progress& progress)
  {
    std::vector<ArcRow> met;
    ImproveInWindows(this->Mesh, this->Problem, this->Most.window, best, met, progress);
    for (ArcRow& row : met)
    {
      if (std::find(this->Rows.begin(), this->Rows.end(), row) == this->Rows.end())
      {
        this->Rows.push_back(std::move(row));
      }
    }
  }

  /// Rows that do not hold for the best numbers, and with them what they proved. Whether there were such rows.
  bool DropBroken(const std::vector<int>& best)
  {
    const auto broken = std::remove_if(this->Rows.begin(), this->Rows.end(),
      [&best](const ArcRow& row) { return !row.Holds(best); });
    const bool any = broken != this->Rows.end();
    this->Rows.erase(broken, this->Rows.end());
    return any;
  }

  /// Arcs whose numbers over the reals are others are free (Danna, Rothberg, Le Pape 2005).
  void SearchDifferences(const std::vector<double>& relaxed, IntegerCounts& best)
  {
    // Most need none.
    constexpr int MostNodes = 100;
    bool isBetter = !relaxed.empty();
    while (isBetter)
    {
      std::vector<int> free;
      std::copy_if(this->All.begin(), this->All.end(), std::back_inserter(free),
        [&](int arc)
        {
          // Far above what the simplex method is exact to.
          constexpr double Same = 1e-6;
          return std::abs(relaxed[Index(arc)] - best.counts[Index(arc)]) > Same;
        });
      isBetter = !free.empty() &&
        ImproveCounts(this->Mesh, this->Problem, free, MostNodes, best, this->Rows).isBetter;
    }
  }

  const TMesh& Mesh;
  const ArcProblem& Problem;
  const Effort Most;
  std::vector<int> All;
  std::vector<ArcRow> Rows;
};
}

ArcCounts CountArcs(
  const TMesh& mesh, const ArcProblem& problem, ArcSearch search, const Progress& progress)
{
  Stopwatch stopwatch;
  IntegerCounts best = SolveArcFlow(problem);
  ArcCounts result;
  result.bound = best.optimal ? best.cost : best.bound;
  if (!FindViolations(mesh, best.counts).empty())
  {
    best = KeepAllArcs(mesh, problem);
  }
  if (best.cost > result.bound + CostRounding(result.bound))
  {
    Turns(mesh, problem, EffortFor(problem, search)).Run(best, result, progress);
  }
  result.counts = std::move(best.counts);
  result.cost = best.cost;
  result.zeroArcs = static_cast<int>(std::count(result.counts.begin(), result.counts.end(), 0));
  result.optimal = result.cost <= result.bound + CostRounding(result.bound);
  result.gap = result.optimal ? 0.0 : (result.cost - result.bound) / (1.0 + result.bound);
  result.seconds = stopwatch.Lap();
  return result;
}
}
