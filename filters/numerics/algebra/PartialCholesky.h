#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>

#include <vector>

namespace crossfield
{
/// Elimination of the inner unknowns of a symmetric positive definite matrix with a border, in the
/// given order,
///   [ A_ii A_ibᵀ ; A_ib A_bb ] = [ L 0 ; M 1 ] [ 1 0 ; 0 S ] [ Lᵀ Mᵀ ; 0 1 ],  S = A_bb − M Mᵀ.
/// CHOLMOD analyses the matrix. The blocks of columns with equal rows that it finds (supernodes) are
/// eliminated as dense matrices, each of which passes M Mᵀ of its own columns to the next one that
/// contains one of its rows (multifrontal; J. Liu, The multifrontal method for sparse matrix
/// solution, 1992). CHOLMOD's own elimination would have to include the border.
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
    int first = 0;          ///< First column.
    int width = 0;          ///< Number of columns.
    int height = 0;         ///< Number of rows.
    int parent = -1;        ///< The node that contains the first row below the columns.
    std::size_t rows = 0;   ///< First row in RowList.
    std::size_t values = 0; ///< First entry in Values, column by column.
  };

  /// Finds the nodes.
  void Analyse(const Eigen::SparseMatrix<double>& lower);
  /// Computes the values.
  void Eliminate(const Eigen::SparseMatrix<double>& lower, Eigen::Ref<Eigen::MatrixXd> border);
  const int* RowsOf(const Node& node) const { return this->RowList.data() + node.rows; }
  Eigen::Map<const Eigen::MatrixXd> ValuesOf(const Node& node) const
  {
    return { this->Values.data() + node.values, node.height, node.width };
  }

  int Inner;
  std::vector<Node> Nodes;
  std::vector<int> NodeOf; ///< Of each inner unknown.
  std::vector<int> RowList;
  std::vector<double> Values;
};
}
