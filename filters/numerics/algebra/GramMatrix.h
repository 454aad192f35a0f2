#pragma once

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// Rows of a matrix V that have entries in the columns of some blocks only.
struct GramNode
{
  std::vector<int> blocks; ///< In increasing order.
  Eigen::MatrixXd rows;    ///< The columns of the first of these blocks, then those of the next.
};

/// A symmetric positive semidefinite matrix of blocks, diag(D_i) + Vᵀ V with a V whose rows have entries in few blocks: the
/// Schur complement on holes that are eliminated where they lie (docs/method.md §3.3). Rows of the matrix are those of
/// block 0, then those of block 1, and so on.
class GramMatrix
{
public:
  /// Without any block.
  GramMatrix() = default;

  /// Of blocks of these sizes, by V alone. What one block has for itself is gathered in its D.
  GramMatrix(const std::vector<Eigen::Index>& sizes, std::vector<GramNode> nodes);

  /// R Rᵀ with a square root R that has entries everywhere.
  GramMatrix(const std::vector<Eigen::Index>& sizes, const Eigen::MatrixXd& root);

  /// Adds a symmetric matrix to a block.
  void AddToBlock(int block, const Eigen::MatrixXd& matrix);

  int BlockCount() const { return static_cast<int>(this->Own.size()); }
  Eigen::Index Rows() const { return this->Firsts.empty() ? 0 : this->Firsts.back(); }
  /// The first row of a block.
  Eigen::Index First(int block) const { return this->Firsts[static_cast<std::size_t>(block)]; }
  Eigen::Index Size(int block) const { return this->First(block + 1) - this->First(block); }

  /// How many numbers are stored.
  Eigen::Index Entries() const;

  double Trace() const;

  /// Times the columns of a matrix.
  Eigen::MatrixXd operator*(const Eigen::MatrixXd& columns) const;
  Eigen::VectorXcd operator*(const Eigen::VectorXcd& column) const;

  /// The rows and columns of one block.
  Eigen::MatrixXd Block(int block) const;

  /// All of it.
  Eigen::MatrixXd Dense() const;

  /// Qᵀ M Q with Q_i in block i and zero elsewhere.
  GramMatrix Congruence(const std::vector<Eigen::MatrixXd>& ofBlocks) const;

  /// Of every column, the sum of the squares of its entries outside its block. Only two blocks of rows are made at a time.
  Eigen::VectorXd SquaredCouplings() const;

private:
  void SetSizes(const std::vector<Eigen::Index>& sizes);

  std::vector<Eigen::Index> Firsts; ///< Of every block, and the number of rows.
  std::vector<Eigen::MatrixXd> Own; ///< D_i.
  std::vector<GramNode> Nodes;      ///< With two blocks or more.
};
}
