#pragma once

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// Rows of a matrix V that have entries in the columns of a few blocks only.
struct GramNode
{
  std::vector<int> blocks; ///< Block numbers, in increasing order.
  /// Entries in the columns of these blocks, block after block.
  Eigen::MatrixXd rows;
};

/// Symmetric positive semidefinite block matrix diag(D_i) + Vᵀ V, where each row of V has entries
/// in few blocks. It is the Schur complement on holes that are eliminated in place (docs/method.md
/// §3.3). Rows of the matrix are those of block 0, then those of block 1, and so on.
class GramMatrix
{
public:
  /// Constructs a matrix without blocks.
  GramMatrix() = default;

  /// Constructs Vᵀ V for blocks of the given sizes. Nodes that belong to a single block are added
  /// to its D.
  GramMatrix(const std::vector<Eigen::Index>& sizes, std::vector<GramNode> nodes);

  /// Constructs R Rᵀ from a dense square root R.
  GramMatrix(const std::vector<Eigen::Index>& sizes, const Eigen::MatrixXd& root);

  /// Adds a symmetric matrix to a diagonal block.
  void AddToBlock(int block, const Eigen::MatrixXd& matrix);

  int BlockCount() const { return static_cast<int>(this->Own.size()); }
  Eigen::Index Rows() const { return this->Firsts.empty() ? 0 : this->Firsts.back(); }
  /// Returns the first row of a block.
  Eigen::Index First(int block) const { return this->Firsts[block]; }
  Eigen::Index Size(int block) const { return this->First(block + 1) - this->First(block); }

  /// Returns the number of stored entries.
  Eigen::Index Entries() const;

  double Trace() const;

  /// Returns the product with the columns of a matrix.
  Eigen::MatrixXd operator*(const Eigen::MatrixXd& columns) const;
  Eigen::VectorXcd operator*(const Eigen::VectorXcd& column) const;

  /// Returns the diagonal block with the rows and columns of one block.
  Eigen::MatrixXd Block(int block) const;

  /// Returns the matrix in dense storage.
  Eigen::MatrixXd Dense() const;

  /// Returns Qᵀ M Q, where Q is block diagonal with the blocks Q_i in `ofBlocks`.
  GramMatrix Congruence(const std::vector<Eigen::MatrixXd>& ofBlocks) const;

  /// Returns, for every column, the sum of squares of its entries outside its own block. Holds the
  /// rows of one block per thread at a time.
  Eigen::VectorXd SquaredCouplings() const;

private:
  void SetSizes(const std::vector<Eigen::Index>& sizes);

  std::vector<Eigen::Index> Firsts; ///< First row of every block, then the number of rows.
  std::vector<Eigen::MatrixXd> Own; ///< D_i.
  std::vector<GramNode> Nodes;      ///< Nodes with at least two blocks.
};
}
