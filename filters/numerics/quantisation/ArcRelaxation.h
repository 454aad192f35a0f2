#pragma once

#include "ArcProblem.h"
#include "SeparationRow.h"

#include <memory>
#include <vector>

namespace crossfield
{
/// Of one column.
struct ColumnBounds
{
  int column = 0;
  int least = 0;
  int most = 0;
};

/// The state of every column and row, as GLPK numbers them.
struct RelaxationBasis
{
  std::vector<char> columns;
  std::vector<char> rows;
};

enum class RelaxationStatus
{
  Optimal,
  Dear,    ///< Costs as much as the limit, or nothing is allowed.
  Unsolved ///< Numerical trouble: nothing is known.
};

/// An ArcProblem with rows for what must stay apart over the reals, by GLPK's dual simplex method, and cuts of Gomory
/// (docs/method.md §14.3). Always goes on from the last basis.
///
/// n = ⌊ℓ⌋ − d + m + u with 0 ≤ d ≤ ⌊ℓ⌋, 0 ≤ m ≤ 1, u ≥ 0: three columns an arc, whose costs are the slopes of
/// w |n − ℓ|. Then the absolute value needs no row, and without rows the relaxation is that of the flow. Lower bounds of
/// the problem are not used.
class ArcRelaxation
{
public:
  /// Only the arcs `free` are free. The others keep the counts that are given, which solve the equations.
  ArcRelaxation(
    const ArcProblem& problem, const std::vector<int>& free, const std::vector<int>& counts);
  ~ArcRelaxation();
  ArcRelaxation(const ArcRelaxation&) = delete;
  ArcRelaxation& operator=(const ArcRelaxation&) = delete;

  void Add(const ArcRow& row);
  /// A cost of which it is enough to know that it is reached.
  void SetLimit(double cost);
  RelaxationStatus Solve();

  // Of the optimum:
  double GetCost() const;
  /// n of an arc.
  double Relaxed(int arc) const;
  bool IsIntegral(int arc) const;
  /// The nearest whole numbers.
  std::vector<int> GetCounts() const;
  RelaxationBasis GetBasis() const;

  /// A round of cuts instead of those that are not tight. Whether there are new ones. Nothing may be narrowed.
  bool Cut();
  /// Bounds of all that costs less than the limit, by the reduced costs. Nothing may be narrowed.
  void Tighten();

  const std::vector<int>& GetFree() const;
  /// n ≤ most.
  std::vector<ColumnBounds> AtMost(int arc, int most) const;
  /// n ≥ least.
  std::vector<ColumnBounds> AtLeast(int arc, int least) const;
  /// Instead of what was narrowed before.
  void Narrow(const std::vector<ColumnBounds>& bounds);
  /// Where the next solution begins. Rows that have been added since are basic.
  void SetBasis(const RelaxationBasis& basis);

private:
  struct Program;
  std::unique_ptr<Program> Data;
};
}
