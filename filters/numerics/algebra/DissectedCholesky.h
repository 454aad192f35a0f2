#pragma once

#include "DenseCholesky.h"
#include "GramMatrix.h"
#include "NestedDissection.h"
#include "PartialCholesky.h"
#include "Progress.h"

#include <functional>
#include <memory>

namespace crossfield
{
/// Cholesky factorisation of a symmetric positive definite matrix whose unknowns have positions in
/// the plane, by nested dissection (docs/method.md §10.2), with the parts of its tree in parallel.
///
/// The unknowns below and above a separator are coupled through it only. Each part has a border: the
/// unknowns of the parts above that are coupled to it or to the parts below it. A leaf is eliminated
/// as a sparse matrix, a separator as a dense one; the Schur complement that this leaves on the
/// border is added to the part above. The root consists of the first separator and the trailing
/// unknowns, which are eliminated last. L is the factor of the complete matrix in the order of the
/// parts, and does not depend on the number of threads.
class DissectedCholesky
{
public:
  /// Factors the matrix. Both triangles of `matrix` are stored; `places` has one point per unknown;
  /// the unknowns in `trailing` are eliminated last, in that order; rows and columns in `leftOut`
  /// are not part of the system; `partners` as in Dissect. Throws Error when an entry is not
  /// finite, and NotPositiveDefinite when the matrix is not.
  DissectedCholesky(const Eigen::SparseMatrix<double>& matrix,
    const std::vector<SpacePoint>& places, const std::vector<int>& trailing,
    const std::vector<int>& leftOut, const Progress& progress = {},
    const std::vector<int>& partners = {});

  /// L⁻¹ b by parts.
  struct Eliminated
  {
    std::vector<Eigen::MatrixXd> parts; ///< All parts except the root.
    Eigen::MatrixXd border; ///< The root; its last rows belong to the trailing unknowns.
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
    /// Position of the first row of a node in a part; the root has the largest number.
    struct Place
    {
      std::size_t part;
      Eigen::Index first;
    };
    /// First column of each B_i, then the total number of columns.
    std::vector<Eigen::Index> firsts;
    std::vector<GramNode> nodes; ///< The last node is that of the root, with all blocks.
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
  /// Part of the tree. Its local rows are its unknowns, followed by its border.
  struct Part
  {
    std::vector<int> unknowns; ///< In elimination order.
    int first = 0;             ///< Position of the first of them in the elimination order.
    int parent = -1;
    int height = 0;            ///< 0 for leaves; above, larger than that of all parts below.
    std::vector<int> below;    ///< Numbers of the parts directly below.
    std::vector<int> border;   ///< Positions in the elimination order.
    std::vector<int> inParent; ///< Local rows of the border in the part above.
    std::unique_ptr<PartialCholesky> leaf;
    Eigen::MatrixXd lower; ///< Columns of L of a separator, in its local rows.

    Eigen::Index Size() const { return static_cast<Eigen::Index>(this->unknowns.size()); }
    Eigen::Index Rows() const
    {
      return this->Size() + static_cast<Eigen::Index>(this->border.size());
    }
  };

  /// Finds the borders.
  void ConnectParts(const Eigen::SparseMatrix<double>& matrix);
  void RequireMemoryForFactor() const;
  /// Calls function(part) for all parts except the root, those below others first, or those above
  /// others first; in parallel if `parallel` is set.
  void ForParts(
    bool parallel, bool upwards, const std::function<void(std::size_t)>& function) const;
  /// Returns the local row of a position in a part, −1 if the part has no such row.
  static int LocalRow(const Part& part, int position);
  /// Eliminates the unknowns of a part, and returns the lower triangle of what this adds to its
  /// border. `updates` are those of the parts below; they are released.
  Eigen::MatrixXd FactorPart(const Eigen::SparseMatrix<double>& matrix, Part& part,
    std::vector<Eigen::MatrixXd>& updates) const;
  void EliminateColumns(const Eigen::MatrixXd& rightHandSides, Eigen::Index begin, Eigen::Index end,
    Eliminated& eliminated) const;
  void SubstituteColumns(const Eliminated& eliminated, Eigen::Index begin, Eigen::Index end,
    Eigen::MatrixXd& solution) const;
  Eigen::MatrixXd FactorLeaf(const Eigen::SparseMatrix<double>& matrix, Part& part) const;
  /// Returns the entries of the matrix in the columns of a part and its local rows, plus the updates
  /// of the parts below.
  Eigen::MatrixXd AssembleFront(const Eigen::SparseMatrix<double>& matrix, const Part& part,
    std::vector<Eigen::MatrixXd>& updates) const;

  std::vector<Part> Parts;    ///< The last one is the root.
  std::vector<int> Positions; ///< Of all unknowns in the elimination order; −1 if left out.
  std::vector<std::vector<int>> Levels; ///< Numbers of parts by height, without the root.
  DenseCholesky<double> RootFactor;
  Eigen::MatrixXd TrailingFactor;
  Eigen::Index Size;
};
}
