#pragma once

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// A real symmetric matrix of blocks, of which each is coupled to the others by its last unknowns only
/// (docs/method.md §3.4). Rows are those of block 0, then those of block 1, and so on.
struct BlockMatrix
{
  std::vector<Eigen::MatrixXd> blocks;
  std::vector<Eigen::Index> coupled; ///< How many of the last unknowns of each block are coupled.
  /// Over the coupled unknowns of all blocks, in the order of the rows: both halves, and zero between those of one
  /// block.
  Eigen::MatrixXd coupling;

  Eigen::Index Rows() const;
  double Trace() const;
  /// Times the columns of a matrix.
  Eigen::MatrixXcd operator*(const Eigen::MatrixXcd& columns) const;
};
}
