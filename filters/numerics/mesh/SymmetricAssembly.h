#pragma once

#include <Eigen/SparseCore>

#include <vector>

namespace crossfield
{
/// Off-diagonal entry of a symmetric matrix, which stands for (row, column) and (column, row).
struct SymmetricEntry
{
  int row;
  int column;
  double value;
};

/// Assembles a symmetric matrix with both triangles stored, in compressed form with sorted rows.
/// Repeated off-diagonal entries are added up.
///
/// Entries are counted before they are stored, which is several times faster than sorting triplets.
Eigen::SparseMatrix<double> AssembleSymmetric(
  const Eigen::VectorXd& diagonal, const std::vector<SymmetricEntry>& offDiagonal);

/// The same with the diagonal for which all rows add up to zero: the constants are the kernel.
Eigen::SparseMatrix<double> AssembleZeroRowSums(
  Eigen::Index size, const std::vector<SymmetricEntry>& offDiagonal);
}
