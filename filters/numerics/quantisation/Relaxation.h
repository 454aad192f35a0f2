#pragma once

#include "LinearSolver.h"
#include "QuantisationProblem.h"
#include "SeparationRow.h"

#include <memory>
#include <utility>
#include <vector>

namespace crossfield
{
/// Integral bounds of one column of a Relaxation.
struct ColumnBounds
{
  int column = 0;
  int lower = 0;
  int upper = 0;
};

/// The linear relaxation of a QuantisationProblem with separation rows and Gomory cuts
/// (docs/method.md §14.3). Every solution starts from the last basis.
///
/// n = ⌊ℓ⌋ − d + m + u with 0 ≤ d ≤ ⌊ℓ⌋, 0 ≤ m ≤ 1, u ≥ 0: three columns per arc, whose costs are
/// the slopes of w |n − ℓ|. So the absolute value needs no row, and without separation rows the
/// relaxation is that of the flow. Lower bounds of the problem are not used, prescribed sums are.
class Relaxation
{
public:
  /// Builds the relaxation in which only the arcs `free` are variables. The others keep `counts`,
  /// which satisfy the equations.
  Relaxation(const QuantisationProblem& problem, const std::vector<int>& free,
    const std::vector<int>& counts);

  void AddRow(const SeparationRow& row);
  /// Sets the cutoff: the search needs no relaxation whose cost reaches it.
  void SetCutoff(double cost) { this->Solver->SetCutoff(cost); }
  SolveStatus Solve() { return this->Solver->Solve(); }

  // Values at the optimum:
  double GetCost() const { return this->Solver->GetObjective(); }
  /// Returns n of an arc.
  double GetCount(int arc) const;
  bool IsIntegral(int arc) const;
  /// Returns the nearest integers.
  std::vector<int> GetRoundedCounts() const;
  SimplexBasis GetBasis() const;

  /// Replaces cuts that are not tight by a round of new ones. Returns whether there are new ones.
  /// The bounds must be those of the root.
  bool AddCuts();
  /// Tightens the bounds of the root by reduced costs: they keep every solution below the cutoff.
  /// The bounds must be those of the root.
  void TightenBounds();

  const std::vector<int>& GetFree() const { return this->Free; }
  /// Returns the bounds that mean n ≤ maximum.
  std::vector<ColumnBounds> AtMost(int arc, int maximum) const;
  /// Returns the bounds that mean n ≥ minimum.
  std::vector<ColumnBounds> AtLeast(int arc, int minimum) const;
  /// Replaces the bounds of the previous node by those of another one, which are within those of
  /// the root.
  void SetNodeBounds(const std::vector<ColumnBounds>& bounds);
  /// Sets the basis from which the next solve starts. Rows added after that basis was stored are
  /// basic.
  void SetBasis(const SimplexBasis& basis);

private:
  using Terms = std::vector<std::pair<int, int>>;

  bool IsFree(int arc) const;
  void AddColumns();
  void AddColumn(double cost, int upper);
  void AddEquations();
  void AddSums();
  /// Adds a row of terms (arc, factor).
  void AddRow(const Terms& terms, RowKind kind, int rhs);
  void RemoveLooseCuts();
  void SetBounds(const ColumnBounds& bounds);

  const QuantisationProblem& Problem;
  const std::vector<int> Free;
  const std::vector<int> Counts; ///< Edge counts of arcs that are not free.
  std::unique_ptr<LinearSolver> Solver;
  std::vector<int> FirstColumn;         ///< Per arc, negative if it is not free.
  std::vector<int> Floors;              ///< ⌊ℓ⌋ per arc.
  std::vector<ColumnBounds> RootBounds; ///< Per column.
  std::vector<int> Narrowed;            ///< Columns that have other bounds at the present node.
  std::vector<char> IsCut;              ///< Per row.
};
}
