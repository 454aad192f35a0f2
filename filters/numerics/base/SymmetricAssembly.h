#pragma once

#include <Eigen/SparseCore>

#include <vector>

namespace crossfield
{
/// The entry of a symmetric matrix in both places.
struct SymmetricEntry
{
  int row;
  int column;
  double value;
};

/// A symmetric matrix with both halves stored, compressed, rows in order; entries off the diagonal may come several times and
/// are added up. Filled after a count, which is several times faster than sorting triplets.
Eigen::SparseMatrix<double> AssembleSymmetric(
  const Eigen::VectorXd& diagonal, const std::vector<SymmetricEntry>& offDiagonal);
}
