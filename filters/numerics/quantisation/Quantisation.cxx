#include "Quantisation.h"

#include "BidirectedFlow.h"
#include "Error.h"
#include "PrescribedSums.h"
#include "Relaxation.h"
#include "Separation.h"
#include "Stopwatch.h"
#include "Subproblem.h"
#include "WindowSearch.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns counts of at least one edge everywhere, and at least MinimumLoop around every loop, so that no
/// points coincide. Returns none if paired sides or prescribed sums do not permit that.
std::vector<int> CountAllArcs(const TMesh& mesh, QuantisationProblem problem)
{
  if (!problem.sums.empty())
  {
    return {};
  }
  const auto raise = [&problem](int arc, int least)
  { problem.lower[arc] = std::max(problem.lower[arc], least); };
  for (int arc = 0; arc < static_cast<int>(problem.Count()); ++arc)
  {
    raise(arc, 1);
  }
  std::vector<int> counts = SolveBidirectedFlow(problem).counts;
  if (counts.empty())
  {
    return counts;
  }
  const std::vector<Violation> shortLoops = FindViolations(mesh, counts);
  for (const Violation& loop : shortLoops)
  {
    for (const int arc : loop.arcs)
    {
      raise(arc, MinimumLoop);
    }
  }
  return shortLoops.empty() ? counts : SolveBidirectedFlow(problem).counts;
}

/// Returns counts that hold all sums and keep points apart. Throws Error if there are none.
std::vector<int> FeasibleCounts(const TMesh& mesh, const QuantisationProblem& problem)
{
  std::optional<std::vector<int>> counts = FindFeasibleCounts(mesh, problem);
  if (!counts)
  {
    throw Error(DescribeConflict(mesh, problem));
  }
  return std::move(*counts);
}

/// Limits of a search.
struct SearchLimits
{
  std::size_t window = 0; ///< Arcs of the largest windows.
  int nodes = 0;          ///< Nodes of each search of the full problem.
  int rounds = 0;
  double gap = 0.0; ///< Counts that cost at most 1 + gap times as much as any end the search.
  int flows = MaximumFlows;

  /// Returns the limits of a search with a number of nodes. Rounds of cuts raise the bound by less and less, and take
  /// most of the time: they end once ten more could not close the gap.
  BranchLimits Branch(int maximumNodes) const { return { maximumNodes, 0.1 * this->gap }; }
};

SearchLimits LimitsFor(const QuantisationProblem& problem, SearchEffort effort, bool isContinued)
{
  // A thorough round takes a second or two, and a few with thousands of arcs. Nodes are limited instead
  // of seconds, so that the result is the same on every machine.
  constexpr int ArcsTimesNodes = 250000;
  constexpr int MinimumNodes = 60;
  constexpr int QuickFraction = 20;
  const int nodes = std::max(MinimumNodes, ArcsTimesNodes / static_cast<int>(problem.Count()));
  const bool isQuick = effort == SearchEffort::Quick;
  SearchLimits limits = { isQuick ? std::size_t(100) : std::size_t(200),
    isQuick ? nodes / QuickFraction : nodes, isQuick ? 1 : 3 };
  if (isContinued)
  {
    // Counts of one size are the start for the next. If they were poor, numbers of quads of different sizes could not
    // be compared; these gaps are small enough for that.
    limits.rounds = 6;
    limits.gap = isQuick ? 0.03 : 0.01;
    // Each flow takes longer than one of fewer arcs, and branch and cut starts with counts of any cost.
    constexpr int ArcsTimesFlows = 50000;
    limits.flows = std::clamp(ArcsTimesFlows / static_cast<int>(problem.Count()), 1, MaximumFlows);
  }
  return limits;
}

/// Solves the relaxation with separation rows, which is integral in most problems. Otherwise searches
/// windows, the full problem, and the arcs in which the two differ, in rounds until nothing improves the
/// counts.
class RoundSearch
{
public:
  /// `rows` are known ones, and receive those that are found.
  RoundSearch(const TMesh& mesh, const QuantisationProblem& problem, const SearchLimits& limits,
    std::vector<SeparationRow>& rows)
    : Mesh(mesh)
    , Problem(problem)
    , Limits(limits)
    , AllArcs(problem.Count())
    , Rows(rows)
  {
    std::iota(this->AllArcs.begin(), this->AllArcs.end(), 0);
  }

  /// Improves counts that satisfy the separation constraints. On entry, `best.bound` is the bound
  /// of the flow; it is improved too.
  void Run(EdgeCounts& best)
  {
    const double flowBound = best.bound;
    std::vector<double> relaxed;
    this->SearchAll(0, best, relaxed);
    if (best.IsProved())
    {
      return;
    }
    for (int round = 0; round < this->Limits.rounds &&
         (this->Limits.gap == 0.0 || best.cost > (1.0 + this->Limits.gap) * best.bound);
         ++round)
    {
      const double before = best.cost;
      const std::size_t rows = this->Rows.size();
      this->SearchWindows(best);
      if (this->DropViolatedRows(best.counts))
      {
        best.bound = flowBound;
      }
      if (best.IsProved() && best.cost >= before)
      {
        return;
      }
      this->SearchAll(this->Limits.nodes, best, relaxed);
      this->SearchDifferences(relaxed, best);
      if (best.cost >= before && this->Rows.size() == rows)
      {
        return; // the next round would be the same
      }
    }
  }

private:
  /// Searches with all arcs free.
  void SearchAll(int maximumNodes, EdgeCounts& best, std::vector<double>& relaxed)
  {
    EdgeCounts full = SolveSubproblem(this->Mesh, this->Problem, this->AllArcs,
      this->Limits.Branch(maximumNodes), best, this->Rows, &relaxed);
    best.bound = std::max(best.bound, full.bound);
    best.nodes += full.nodes;
    ReplaceIfCheaper(best, std::move(full));
  }

  /// Starts without the known rows, so that counts that violate them are found too.
  void SearchWindows(EdgeCounts& best)
  {
    std::vector<SeparationRow> generated;
    ImproveInWindows(this->Mesh, this->Problem, this->Limits.window, best, generated);
    for (SeparationRow& row : generated)
    {
      if (std::find(this->Rows.begin(), this->Rows.end(), row) == this->Rows.end())
      {
        this->Rows.push_back(std::move(row));
      }
    }
  }

  /// Removes rows that the best counts violate, and returns whether there were any: bounds proved
  /// with them are void.
  bool DropViolatedRows(const std::vector<int>& best)
  {
    const auto violated = std::remove_if(this->Rows.begin(), this->Rows.end(),
      [&best](const SeparationRow& row) { return !row.Holds(best); });
    const bool any = violated != this->Rows.end();
    this->Rows.erase(violated, this->Rows.end());
    return any;
  }

  /// Searches with those arcs free whose relaxed count is not the best one (Danna, Rothberg, Le
  /// Pape 2005).
  void SearchDifferences(const std::vector<double>& relaxed, EdgeCounts& best)
  {
    // Most of these subproblems need fewer.
    constexpr int MaximumNodes = 100;
    bool isImproved = !relaxed.empty();
    while (isImproved)
    {
      std::vector<int> free;
      std::copy_if(this->AllArcs.begin(), this->AllArcs.end(), std::back_inserter(free),
        [&](int arc)
        {
          // Far above the accuracy of the simplex method.
          constexpr double Same = 1e-6;
          return std::abs(relaxed[arc] - best.counts[arc]) > Same;
        });
      isImproved = !free.empty() &&
        ReplaceIfCheaper(best,
          SolveSubproblem(
            this->Mesh, this->Problem, free, this->Limits.Branch(MaximumNodes), best, this->Rows));
    }
  }

  const TMesh& Mesh;
  const QuantisationProblem& Problem;
  const SearchLimits Limits;
  std::vector<int> AllArcs;
  std::vector<SeparationRow>& Rows;
};

/// Returns the optimal flow, with counts that may cost more if points coincide in it.
EdgeCounts SeparatedFlow(const TMesh& mesh, const QuantisationProblem& problem,
  const QuantisationProblem& flow, int maximumFlows)
{
  EdgeCounts best = SolveBidirectedFlow(flow, maximumFlows);
  best.nodes = 0; // only nodes of branch and cut are counted
  if (!flow.HoldsSums(best.counts) || !FindViolations(mesh, best.counts).empty())
  {
    best.counts = CountAllArcs(mesh, flow);
    if (best.counts.empty())
    {
      best.counts = FeasibleCounts(mesh, problem);
    }
    best.cost = flow.Cost(best.counts);
  }
  return best;
}
}

EdgeCounts Quantise(
  const TMesh& mesh, const QuantisationProblem& problem, SearchEffort effort, KnownCounts* known)
{
  Stopwatch stopwatch;
  const QuantisationProblem flow = WithSumsAsEquations(problem);
  KnownCounts none;
  KnownCounts& start = known != nullptr ? *known : none;
  const bool isStarted = !start.counts.empty() && problem.IsFeasible(start.counts);
  EdgeCounts best;
  // Where rows were needed for other targets, the flow violates them for these too, and the relaxation with the rows
  // bounds the cost more tightly.
  if (!isStarted || start.rows.empty())
  {
    best = SeparatedFlow(mesh, problem, flow, LimitsFor(flow, effort, known != nullptr).flows);
  }
  if (isStarted && (best.counts.empty() || flow.Cost(start.counts) < best.cost))
  {
    best.counts = start.counts;
    best.cost = flow.Cost(best.counts);
  }
  const auto search = [&](SearchEffort with)
  {
    if (!best.IsProved())
    {
      RoundSearch(mesh, flow, LimitsFor(flow, with, known != nullptr), start.rows).Run(best);
    }
  };
  if (known != nullptr && !isStarted && effort == SearchEffort::Thorough)
  {
    // Most rows are found while counts are poor, with a few nodes as well as with many.
    const double flowBound = best.bound;
    search(SearchEffort::Quick);
    best.bound = best.IsProved() ? best.bound : flowBound;
  }
  search(effort);
  start.counts = best.counts;
  best.optimal = best.IsProved();
  best.seconds = stopwatch.Lap();
  return best;
}

std::vector<double> RelaxCounts(const QuantisationProblem& problem, const KnownCounts& known)
{
  const QuantisationProblem flow = WithSumsAsEquations(problem);
  std::vector<int> all(flow.Count());
  std::iota(all.begin(), all.end(), 0);
  Relaxation relaxation(flow, all, {});
  for (const SeparationRow& row : known.rows)
  {
    relaxation.AddRow(row);
  }
  if (relaxation.Solve() != SolveStatus::Optimal)
  {
    return { known.counts.begin(), known.counts.end() };
  }
  std::vector<double> relaxed;
  for (const int arc : all)
  {
    relaxed.push_back(relaxation.GetCount(arc));
  }
  return relaxed;
}
}
