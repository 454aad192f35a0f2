#pragma once

#include "DenseCholesky.h"
#include "GramMatrix.h"
#include "Plane.h"
#include "Progress.h"
#include "SparseCholesky.h"

#include <array>

namespace crossfield
{
/// Cholesky factorisation of a symmetric positive definite matrix whose unknowns have places in the
/// plane, by nested dissection (docs/method.md §10.2), its two halves in two threads.
///
/// The first separator and the trailing unknowns, those that are to come last, are the border. CHOLMOD
/// factors each half together with the border's unknowns next to it; what that leaves on them is the half's part
/// of the border's Schur complement, which is dense. L is that of the whole matrix in the order left
/// half, right half, border, and the same whatever the number of threads.
class DissectedCholesky
{
public:
  /// `matrix` has both halves stored; `places` has a point per unknown; the unknowns in `trailing` come
  /// last, in that order; rows and columns in `leftOut` are not part of the system; `partners` as in Dissect. Throws
  /// Error when an entry is not finite, and NotPositiveDefinite when the matrix is not.
  DissectedCholesky(const Eigen::SparseMatrix<double>& matrix, const std::vector<Point>& places,
    const std::vector<int>& trailing, const std::vector<int>& leftOut,
    const Progress& progress = {}, const std::vector<int>& partners = {});

  /// L⁻¹ b, by parts.
  struct Eliminated
  {
    std::array<Eigen::MatrixXd, 2> halves;
    Eigen::MatrixXd border; ///< The last rows belong to the trailing unknowns.
  };

  /// Forward substitution for any number of columns; rows as in the matrix, those of unknowns left
  /// out are ignored.
  Eliminated Eliminate(const Eigen::MatrixXd& rightHandSides) const;

  /// Back substitution: A⁻¹ b, 0 for unknowns left out. Throws Error when it is not finite.
  Eigen::MatrixXd Substitute(const Eliminated& eliminated) const;

  /// V = L⁻¹ B for every B of some with few entries, supernode by supernode: their columns are the blocks of the nodes.
  struct SparseEliminated
  {
    /// Where the first row of a node is: in a half, or, 2, in the border.
    struct Place
    {
      std::size_t part;
      Eigen::Index first;
    };
    std::vector<Eigen::Index> firsts; ///< First column of every block, and the number of columns.
    std::vector<GramNode> nodes;      ///< The last one is that of the border, with all blocks.
    std::vector<Place> places;        ///< Of the nodes.

    /// Vᵀ y.
    Eigen::MatrixXd Against(const Eliminated& eliminated) const;
    /// y + V x.
    void AddTo(Eliminated& eliminated, const Eigen::MatrixXd& x) const;
  };

  /// Rows of B are those of the matrix.
  SparseEliminated EliminateSparse(const std::vector<Eigen::SparseMatrix<double>>& blocks) const;

  /// Lower triangular L_tt of the trailing unknowns: L_tt L_ttᵀ is the Schur complement on them.
  const Eigen::MatrixXd& GetTrailingFactor() const { return this->TrailingFactor; }

private:
  struct Half
  {
    std::vector<int> unknowns; ///< In elimination order.
    std::vector<int> border;   ///< Positions in the border of those next to the half.
    std::unique_ptr<SparseCholesky> factor;
    Eigen::MatrixXd borderFactor; ///< Last block of the half's L.
  };

  /// Factors a half; returns what it adds to the Schur complement on its border.
  Eigen::MatrixXd FactorHalf(const Eigen::SparseMatrix<double>& matrix, Half& half) const;

  std::array<Half, 2> Halves;
  std::vector<int> Border; ///< Separator, then the trailing unknowns.
  DenseCholesky<double> BorderFactor;
  Eigen::MatrixXd TrailingFactor;
  Eigen::Index Size;
};
}
