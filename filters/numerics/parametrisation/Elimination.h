#pragma once

#include <Eigen/SparseCore>

#include <utility>
#include <vector>

namespace crossfield
{
/// Homogeneous linear equations with small whole coefficients, solved exactly by substitution
/// (docs/method.md §12.3): every equation makes one unknown depend on others. Pivots are ±1, so nothing is
/// ever rounded.
class Elimination
{
public:
  using Row = std::vector<std::pair<int, double>>; ///< Unknown and coefficient.

  /// `rank`: of the unknowns with a coefficient ±1 that of least rank is eliminated.
  explicit Elimination(std::vector<int> rank)
    : Rank(std::move(rank))
    , Dependent(this->Rank.size())
    , IsDependent(this->Rank.size(), false)
  {
  }

  /// Σ coefficient · unknown = 0. Does nothing where that follows from what was imposed. Throws Error
  /// when there is no pivot.
  void Impose(const Row& row);

  bool IsFree(int unknown) const { return !this->IsDependent[static_cast<std::size_t>(unknown)]; }

  /// All unknowns from the free ones, which are numbered in their order. Dependent ones that are
  /// no combination of others are zero.
  Eigen::SparseMatrix<double, Eigen::RowMajor> Prolongation();

private:
  /// In terms of free unknowns, ordered.
  Row Resolve(const Row& row);

  std::vector<int> Rank;
  std::vector<Row> Dependent;
  std::vector<bool> IsDependent;
};
}
