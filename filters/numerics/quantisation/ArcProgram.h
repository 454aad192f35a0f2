#pragma once

#include "ArcRelaxation.h"

#include <functional>

namespace crossfield
{
struct ProgramCounts
{
  std::vector<int> counts;
  double cost = 0.0;
  double bound = 0.0; ///< No counts for which the rows hold cost less.
  int nodes = 0;      ///< Of branch and cut.
  std::vector<double>
    relaxed; ///< Counts over the reals at the root, with all cuts; empty where the root decides.
};

/// An ArcProblem with rows for what must stay apart, solved by branch and cut: cuts at the root alone, branches on the number of
/// an arc (docs/method.md §14.3).
class ArcProgram
{
public:
  /// Only the arcs `free` are free. The others keep the counts that are given, which solve the equations and are the best
  /// known.
  ArcProgram(
    const ArcProblem& problem, const std::vector<int>& free, const std::vector<int>& counts);

  /// A row that holds for the counts given.
  void Add(const ArcRow& row);

  /// Rows that counts break and must not; none: nothing is joined.
  using Separate = std::function<std::vector<ArcRow>(const std::vector<int>& counts)>;

  /// The least cost of counts for which `separate` has no rows, which are added where the search meets whole numbers
  /// that break them; those given where nothing costs less. Ends after `mostNodes` nodes, not after a time: the result is
  /// the same on every machine.
  ProgramCounts Solve(int mostNodes, const Separate& separate);

  /// Those added, and those met on the way.
  const std::vector<ArcRow>& GetRows() const { return this->Rows; }

private:
  const ArcProblem& Problem;
  const std::vector<int> Start;
  ArcRelaxation Relaxation;
  std::vector<ArcRow> Rows;
};
}
