#pragma once

#include <limits>
#include <vector>

namespace crossfield
{
/// Upper bound of a variable that has none.
constexpr double Unbounded = std::numeric_limits<double>::infinity();

/// Bounds lower ≤ x ≤ upper. Both are finite, except that `upper` may be Unbounded.
struct VariableBounds
{
  double lower = 0.0;
  double upper = Unbounded;
};

enum class RowKind
{
  AtLeast, ///< Σ value · column ≥ rhs.
  Equal    ///< Σ value · column = rhs.
};

/// A row of the constraint matrix with its right-hand side.
struct LinearRow
{
  std::vector<int> columns;
  std::vector<double> values;
  double rhs = 0.0;
};

enum class BasisStatus
{
  Basic,
  AtLower,
  AtUpper,
  Fixed ///< Nonbasic with equal bounds.
};

/// A simplex basis.
struct SimplexBasis
{
  std::vector<BasisStatus> columns;
  std::vector<BasisStatus> rows;
};

/// An entry of a row of the simplex tableau: the factor of a nonbasic column, or of the value of a
/// nonbasic row.
struct TableauEntry
{
  bool isRow = false;
  int index = 0;
  double factor = 0.0;
};

enum class SolveStatus
{
  Optimal,
  CutOff,  ///< The objective reaches the cutoff, or no point is feasible.
  Unsolved ///< Numerical failure: nothing is known.
};

/// A linear program min cᵀx + c₀ under bounds and rows, solved by the dual simplex method. The only
/// part of quantisation that depends on a library (GlpkSolver.h implements it): branching, cuts and
/// separation are built on it. Columns and rows are numbered from 0 in the order in which they are
/// added.
class LinearSolver
{
public:
  virtual ~LinearSolver() = default;

  virtual void SetConstantCost(double cost) = 0;
  virtual void AddColumn(double cost, const VariableBounds& bounds) = 0;
  /// Adds a row, which is basic.
  virtual void AddRow(const LinearRow& row, RowKind kind) = 0;
  /// Removes rows, given in increasing order; later rows move up.
  virtual void RemoveRows(const std::vector<int>& rows) = 0;
  virtual void SetBounds(int column, const VariableBounds& bounds) = 0;
  virtual VariableBounds GetBounds(int column) const = 0;
  /// Sets the objective at which Solve may stop and return CutOff.
  virtual void SetCutoff(double cost) = 0;
  virtual double GetCutoff() const = 0;

  /// Solves, starting from the present basis.
  virtual SolveStatus Solve() = 0;

  // Valid after Solve returned Optimal:
  virtual double GetObjective() const = 0;
  virtual double GetValue(int column) const = 0;
  virtual double GetReducedCost(int column) const = 0;

  virtual int CountColumns() const = 0;
  virtual int CountRows() const = 0;
  virtual BasisStatus GetColumnStatus(int column) const = 0;
  virtual BasisStatus GetRowStatus(int row) const = 0;
  virtual void SetColumnStatus(int column, BasisStatus status) = 0;
  virtual void SetRowStatus(int row, BasisStatus status) = 0;

  virtual void GetRow(int row, LinearRow& entries) const = 0;
  /// Factorises the basis, which GetTableauRow needs. Returns false if it is singular.
  virtual bool Factorise() = 0;
  /// Writes the tableau row of a basic column: the column equals the sum of the entries, up to a
  /// constant.
  virtual void GetTableauRow(int column, std::vector<TableauEntry>& entries) const = 0;
};
}
