#include "SymmetricAssembly.h"

#include "BothHalves.h"

#include <algorithm>
#include <atomic>
#include <tuple>
#include <utility>

namespace crossfield
{
namespace
{
/// Merges adjacent entries with the same row by adding them.
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

/// Sorts the entries of a column by row, stably. Returns whether a row occurs more than once.
bool SortColumn(int* rows, double* values, int count, std::vector<std::pair<int, double>>& buffer)
{
  // Columns of unknowns coupled to many others are too long for insertion sort.
  constexpr int MaximumToInsert = 32;
  if (count > MaximumToInsert)
  {
    buffer.clear();
    for (int i = 0; i < count; ++i)
    {
      buffer.emplace_back(rows[i], values[i]);
    }
    std::stable_sort(
      buffer.begin(), buffer.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
    for (int i = 0; i < count; ++i)
    {
      std::tie(rows[i], values[i]) = buffer[static_cast<std::size_t>(i)];
    }
    return std::adjacent_find(rows, rows + count) != rows + count;
  }
  bool repeated = false;
  for (int i = 1; i < count; ++i)
  {
    const int row = rows[i];
    const double value = values[i];
    int place = i;
    for (; place > 0 && rows[place - 1] > row; --place)
    {
      rows[place] = rows[place - 1];
      values[place] = values[place - 1];
    }
    rows[place] = row;
    values[place] = value;
    repeated = repeated || (place > 0 && rows[place - 1] == row);
  }
  return repeated;
}
}

Eigen::SparseMatrix<double> AssembleSymmetric(
  const Eigen::VectorXd& diagonal, const std::vector<SymmetricEntry>& offDiagonal)
{
  // Each thread reads all entries and processes those in its half of the columns.
  const auto size = static_cast<int>(diagonal.size());
  std::vector<int> next(static_cast<std::size_t>(size), 1);
  ParallelForHalves(size,
    [&](int begin, int end)
    {
      for (const SymmetricEntry& entry : offDiagonal)
      {
        for (const int column : { entry.row, entry.column })
        {
          if (column >= begin && column < end)
          {
            ++next[static_cast<std::size_t>(column)];
          }
        }
      }
    });
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.resizeNonZeros(size + 2 * static_cast<Eigen::Index>(offDiagonal.size()));
  int* const starts = matrix.outerIndexPtr();
  starts[0] = 0;
  for (int column = 0; column < size; ++column)
  {
    int& position = next[static_cast<std::size_t>(column)];
    starts[column + 1] = starts[column] + position;
    position = starts[column];
  }
  std::atomic<bool> repeated = false;
  ParallelForHalves(size,
    [&](int begin, int end)
    {
      int* const rows = matrix.innerIndexPtr();
      double* const values = matrix.valuePtr();
      const auto place = [&](int row, int column, double value)
      {
        const int position = next[static_cast<std::size_t>(column)]++;
        rows[position] = row;
        values[position] = value;
      };
      for (int j = begin; j < end; ++j)
      {
        place(j, j, diagonal[j]);
      }
      for (const SymmetricEntry& entry : offDiagonal)
      {
        if (entry.column >= begin && entry.column < end)
        {
          place(entry.row, entry.column, entry.value);
        }
        if (entry.row >= begin && entry.row < end)
        {
          place(entry.column, entry.row, entry.value);
        }
      }
      std::vector<std::pair<int, double>> buffer;
      for (int j = begin; j < end; ++j)
      {
        if (SortColumn(rows + starts[j], values + starts[j], starts[j + 1] - starts[j], buffer))
        {
          repeated = true;
        }
      }
    });
  if (repeated)
  {
    MergeRepeated(matrix);
  }
  return matrix;
}
}
