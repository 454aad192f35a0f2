#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <memory>
#include <vector>

namespace crossfield
{
/// Elimination of the inner unknowns of a symmetric positive definite matrix with a border, in the
/// given order (docs/method.md §10.2),
///   [ A_ii A_ibᵀ ; A_ib A_bb ] = [ L 0 ; M 1 ] [ 1 0 ; 0 S ] [ Lᵀ Mᵀ ; 0 1 ],  S = A_bb − M Mᵀ.
/// CHOLMOD computes L and M. It has no elimination of a part of the unknowns, and factoring S, which
/// is dense, would add a third to the operations. So a column whose pivot is negative is inserted
/// before the border: CHOLMOD ends there, and the supernodes before it are valid (the
/// member `minor` of cholmod_factor, and comments in the source of cholmod_super_numeric). It
/// is coupled to no other, so it adds nothing. S is a sum of products of the blocks of columns with
/// equal rows (supernodes) of M.
///
/// Immutable after its construction: const functions may be called from several threads at once.
class PartialCholesky
{
public:
  /// Eliminates the first `inner` unknowns. `lower` has the entries of their columns on and below
  /// the diagonal, sorted; those of other columns are not read. Adds −M Mᵀ to the lower triangle of
  /// `border`. Throws Error when an entry is not finite, and NotPositiveDefinite when A_ii is not.
  PartialCholesky(
    const Eigen::SparseMatrix<double>& lower, int inner, Eigen::Ref<Eigen::MatrixXd> border);

  ~PartialCholesky();
  PartialCholesky(const PartialCholesky&) = delete;
  PartialCholesky& operator=(const PartialCholesky&) = delete;

  int InnerCount() const { return this->Inner; }

  /// Replaces the columns (b, c) by (L⁻¹ b, c − M L⁻¹ b).
  void SolveLower(Eigen::MatrixXd& columns) const;

  /// Replaces the columns (b, x) by (L⁻ᵀ (b − Mᵀ x), x).
  void SolveUpper(Eigen::MatrixXd& columns) const;

  /// Consecutive rows of a matrix, starting at row `first`.
  struct Rows
  {
    int first;
    Eigen::MatrixXd values;
  };
  /// Computes L⁻¹ B for a sparse B with a row for each inner unknown, and adds −M L⁻¹ B to
  /// `atBorder`. Returns the non-zero rows, supernode by supernode: those on the paths of the
  /// elimination tree from the entries of B to the root.
  std::vector<Rows> SolveLowerSparse(
    const Eigen::SparseMatrix<double>& block, Eigen::Ref<Eigen::MatrixXd> atBorder) const;

private:
  /// Columns with equal rows. The first rows are those of the columns.
  struct Node
  {
    int first = 0;        ///< First column.
    int width = 0;        ///< Number of columns.
    int height = 0;       ///< Number of rows.
    int parent = -1;      ///< The node that contains the first row below the columns.
    int inner = 0;        ///< Number of rows of inner unknowns, which precede those of the border.
    std::size_t rows = 0; ///< First row in RowList.
    std::size_t values = 0; ///< First entry in Values, column by column.
  };

  struct Factor;

  /// Finds the nodes.
  void ReadNodes();
  /// Adds −M Mᵀ to the lower triangle.
  void UpdateBorder(Eigen::Ref<Eigen::MatrixXd> border) const;
  const int* RowsOf(const Node& node) const { return this->RowList.data() + node.rows; }
  Eigen::Map<const Eigen::MatrixXd> ValuesOf(const Node& node) const
  {
    return { this->Values + node.values, node.height, node.width };
  }

  int Inner;
  std::unique_ptr<Factor> Data;
  std::vector<Node> Nodes;
  std::vector<int> NodeOf; ///< Of each inner unknown.
  std::vector<int> RowList;
  const double* Values = nullptr; ///< Those of CHOLMOD's factor.
};
}
