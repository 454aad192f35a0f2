#include "SymmetricAssembly.h"

namespace crossfield
{
namespace
{
/// Adds up neighbours of the same row.
void MergeRepeated(Eigen::SparseMatrix<double>& matrix)
{
  int* const starts = matrix.outerIndexPtr();
  int* const rows = matrix.innerIndexPtr();
  double* const values = matrix.valuePtr();
  int begin = 0;
  int kept = 0;
  for (Eigen::Index column = 0; column < matrix.cols(); ++column)
  {
    const int end = starts[column + 1];
    const int first = kept;
    for (int i = begin; i < end; ++i)
    {
      if (kept > first && rows[kept - 1] == rows[i])
      {
        values[kept - 1] += values[i];
        continue;
      }
      rows[kept] = rows[i];
      values[kept++] = values[i];
    }
    begin = end;
    starts[column + 1] = kept;
  }
  matrix.resizeNonZeros(kept);
}
}

Eigen::SparseMatrix<double> AssembleSymmetric(
  const Eigen::VectorXd& diagonal, const std::vector<SymmetricEntry>& offDiagonal)
{
  const Eigen::Index size = diagonal.size();
  Eigen::VectorXi next = Eigen::VectorXi::Ones(size);
  for (const SymmetricEntry& entry : offDiagonal)
  {
    ++next[entry.row];
    ++next[entry.column];
  }
  Eigen::SparseMatrix<double> unsorted(size, size);
  unsorted.resizeNonZeros(size + 2 * static_cast<Eigen::Index>(offDiagonal.size()));
  int* const starts = unsorted.outerIndexPtr();
  starts[0] = 0;
  for (Eigen::Index column = 0; column < size; ++column)
  {
    starts[column + 1] = starts[column] + next[column];
    next[column] = starts[column];
  }
  const auto place = [&](int row, int column, double value)
  {
    const int position = next[column]++;
    unsorted.innerIndexPtr()[position] = row;
    unsorted.valuePtr()[position] = value;
  };
  for (int j = 0; j < static_cast<int>(size); ++j)
  {
    place(j, j, diagonal[j]);
  }
  for (const SymmetricEntry& entry : offDiagonal)
  {
    place(entry.row, entry.column, entry.value);
    place(entry.column, entry.row, entry.value);
  }
  // The matrix equals its transpose, and transposing sorts the rows.
  Eigen::SparseMatrix<double> matrix = unsorted.transpose();
  MergeRepeated(matrix);
  return matrix;
}
}
