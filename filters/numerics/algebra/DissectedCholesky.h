#pragma once

#include "DenseCholesky.h"
#include "GramMatrix.h"
#include "Plane.h"
#include "Progress.h"
#include "SparseCholesky.h"

#include <array>

namespace crossfield
{
/// Cholesky factorisation of a symmetric positive definite matrix whose unknowns have positions in
/// the plane, by nested dissection (docs/method.md §10.2), with its two halves in two threads.
///
/// The border consists of the first separator and the trailing unknowns, which are eliminated last.
/// CHOLMOD factors each half together with the border unknowns coupled to it. The Schur complement
/// that this leaves on them is the half's contribution to the dense Schur complement on the border.
/// L is the factor of the complete matrix in the order left half, right half, border, and does not
/// depend on the number of threads.
class DissectedCholesky
{
public:
  /// Factors the matrix. Both triangles of `matrix` are stored; `places` has one point per unknown;
  /// the unknowns in `trailing` are eliminated last, in that order; rows and columns in `leftOut`
  /// are not part of the system; `partners` as in Dissect. Throws Error when an entry is not
  /// finite, and NotPositiveDefinite when the matrix is not.
  DissectedCholesky(const Eigen::SparseMatrix<double>& matrix, const std::vector<Point>& places,
    const std::vector<int>& trailing, const std::vector<int>& leftOut,
    const Progress& progress = {}, const std::vector<int>& partners = {});

  /// L⁻¹ b, split into the two halves and the border.
  struct Eliminated
  {
    std::array<Eigen::MatrixXd, 2> halves;
    Eigen::MatrixXd border; ///< The last rows belong to the trailing unknowns.
  };

  /// Performs forward substitution for any number of columns. Rows are those of the matrix; rows of
  /// unknowns that are left out are ignored.
  Eliminated Eliminate(const Eigen::MatrixXd& rightHandSides) const;

  /// Performs back substitution: returns A⁻¹ b, with 0 for unknowns that are left out. Throws Error
  /// when the result is not finite.
  Eigen::MatrixXd Substitute(const Eliminated& eliminated) const;

  /// V = L⁻¹ [ B_1 B_2 ... ] for sparse matrices B_i, stored by supernodes. The column blocks of
  /// the nodes are the columns of the B_i.
  struct SparseEliminated
  {
    /// Position of the first row of a node: in a half (part 0 or 1) or in the border (part 2).
    struct Place
    {
      std::size_t part;
      Eigen::Index first;
    };
    /// First column of each B_i, then the total number of columns.
    std::vector<Eigen::Index> firsts;
    std::vector<GramNode> nodes; ///< The last node is that of the border, with all blocks.
    std::vector<Place> places;   ///< Position of each node.

    /// Returns Vᵀ y.
    Eigen::MatrixXd TransposeTimes(const Eliminated& eliminated) const;
    /// Adds V x to y.
    void AddTo(Eliminated& eliminated, const Eigen::MatrixXd& x) const;
  };

  /// Computes L⁻¹ B_i for each block. The rows of B_i are those of the matrix.
  SparseEliminated EliminateSparse(const std::vector<Eigen::SparseMatrix<double>>& blocks) const;

  /// Returns the lower triangular factor L_tt of the trailing unknowns; L_tt L_ttᵀ is the Schur
  /// complement on them.
  const Eigen::MatrixXd& GetTrailingFactor() const { return this->TrailingFactor; }

private:
  struct Half
  {
    std::vector<int> unknowns; ///< Unknowns in elimination order.
    std::vector<int> border;   ///< Positions in the border of the unknowns coupled to the half.
    std::unique_ptr<SparseCholesky> factor;
    Eigen::MatrixXd borderFactor; ///< Last diagonal block of the half's L.
  };

  /// Factors a half and returns its contribution to the Schur complement on its border.
  Eigen::MatrixXd FactorHalf(const Eigen::SparseMatrix<double>& matrix, Half& half) const;

  std::array<Half, 2> Halves;
  std::vector<int> Border; ///< Separator, followed by the trailing unknowns.
  DenseCholesky<double> BorderFactor;
  Eigen::MatrixXd TrailingFactor;
  Eigen::Index Size;
};
}
