#pragma once

#include <Eigen/SparseCore>

#include <utility>
#include <vector>

namespace crossfield
{
/// Exact elimination of homogeneous linear equations with small integer coefficients by
/// substitution (docs/method.md §12.3): every equation makes one unknown depend on others. Pivots
/// are ±1, so no operation is rounded.
class Elimination
{
public:
  using Row = std::vector<std::pair<int, double>>; ///< Unknown and coefficient.

  /// Constructs an elimination without equations. `rank` has a rank per unknown: an equation
  /// eliminates the unknown of minimum rank among those with coefficient ±1.
  explicit Elimination(std::vector<int> rank)
    : Rank(std::move(rank))
    , Dependent(this->Rank.size())
    , IsDependent(this->Rank.size(), false)
  {
  }

  /// Imposes Σ coefficient · unknown = 0. Has no effect if the equation follows from those imposed
  /// before. Throws Error when there is no pivot.
  void Impose(const Row& row);

  bool IsFree(int unknown) const { return !this->IsDependent[unknown]; }

  /// Returns the matrix that maps the free unknowns, numbered in their order, to all unknowns.
  /// Dependent unknowns whose combination is empty are zero.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Prolongation();

private:
  /// Returns the row in terms of free unknowns, sorted.
  Row Resolve(const Row& row);

  std::vector<int> Rank;
  std::vector<Row> Dependent;
  std::vector<bool> IsDependent;
};
}
