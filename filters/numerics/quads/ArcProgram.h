#pragma once

#include "ArcProblem.h"
#include "SeparationRow.h"

#include <functional>
#include <memory>

namespace crossfield
{
struct ProgramCounts
{
  std::vector<int> counts; ///< Empty where none were found.
  double cost = 0.0;
  double bound = 0.0; ///< No counts for which the rows hold cost less.
  int nodes = 0;      ///< Of branch and cut.
};

/// An ArcProblem with rows for what must stay apart, solved by GLPK's branch and cut (docs/method.md §14.3).
///
/// n = ⌊ℓ⌋ − d + m + u with 0 ≤ d ≤ ⌊ℓ⌋, 0 ≤ m ≤ 1, u ≥ 0: three columns an arc, whose costs are the slopes of
/// w |n − ℓ|. Then the absolute value needs no row, and the relaxation is that of the flow. Lower bounds of the problem
/// are not used.
class ArcProgram
{
public:
  /// Only the arcs `free` are free. The others keep the counts that are given, which solve the equations.
  ArcProgram(
    const ArcProblem& problem, const std::vector<int>& free, const std::vector<int>& counts);
  ~ArcProgram();
  ArcProgram(const ArcProgram&) = delete;
  ArcProgram& operator=(const ArcProgram&) = delete;

  void Add(const ArcRow& row);

  /// Rows that counts break and must not; none: nothing is joined.
  using Separate = std::function<std::vector<ArcRow>(const std::vector<int>& counts)>;

  /// The least cost of counts for which `separate` has no rows, which are added where the search meets whole numbers
  /// that break them. Ends after `mostNodes` nodes, not after a time: the result is the same on every machine. `start`
  /// are counts to begin with, for which the rows hold, or none.
  ProgramCounts Solve(const std::vector<int>& start, int mostNodes, const Separate& separate);

  /// Those added, and those met on the way.
  const std::vector<ArcRow>& GetRows() const { return this->Rows; }

private:
  struct Program;
  std::unique_ptr<Program> Data;
  std::vector<ArcRow> Rows;
};
}
