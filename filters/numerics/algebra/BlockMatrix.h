#pragma once

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// Real symmetric block matrix whose blocks are coupled to each other through their last unknowns
/// only (docs/method.md §3.4). Rows are those of block 0, then those of block 1, and so on.
struct BlockMatrix
{
  std::vector<Eigen::MatrixXd> blocks;
  std::vector<Eigen::Index> coupled; ///< Number of coupled unknowns of each block, its last ones.
  /// Couplings between the coupled unknowns of all blocks, in the order of the rows. Both triangles
  /// are stored; entries within a block are zero.
  Eigen::MatrixXd coupling;

  Eigen::Index Rows() const;
  double Trace() const;
  /// Returns the product with the columns of a matrix.
  Eigen::MatrixXcd operator*(const Eigen::MatrixXcd& columns) const;
};
}
