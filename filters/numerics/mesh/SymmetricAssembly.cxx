#include "SymmetricAssembly.h"

#include "Parts.h"

#include <algorithm>
#include <atomic>
#include <cstdint>
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
      std::tie(rows[i], values[i]) = buffer[i];
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

/// Off-diagonal entries by ranges of unknowns: each range lists the entries with a row or column in
/// it, in their order.
class EntriesOfRanges
{
public:
  EntriesOfRanges(std::ptrdiff_t size, const std::vector<SymmetricEntry>& entries)
    : Entries(entries)
    , Ranges(PartCount(size))
    , Parts(PartCount(static_cast<std::ptrdiff_t>(entries.size())))
    , Lists(Ranges == 1 ? 0 : Parts * Ranges)
  {
    if (this->Ranges == 1)
    {
      return;
    }
    std::vector<std::uint8_t> rangeOf(static_cast<std::size_t>(size));
    for (std::size_t range = 0; range < this->Ranges; ++range)
    {
      const auto [begin, end] = PartRange(size, range, this->Ranges);
      std::fill(rangeOf.begin() + begin, rangeOf.begin() + end, static_cast<std::uint8_t>(range));
    }
    ForParts(this->Parts,
      [&](std::size_t part)
      {
        std::vector<int>* const lists = this->Lists.data() + part * this->Ranges;
        const auto [begin, end] =
          PartRange(static_cast<std::ptrdiff_t>(this->Entries.size()), part, this->Parts);
        for (int i = begin; i < end; ++i)
        {
          const SymmetricEntry& entry = this->Entries[i];
          const std::size_t ofRow = rangeOf[entry.row];
          const std::size_t ofColumn = rangeOf[entry.column];
          lists[ofRow].push_back(i);
          if (ofColumn != ofRow)
          {
            lists[ofColumn].push_back(i);
          }
        }
      });
  }

  std::size_t RangeCount() const { return this->Ranges; }

  /// Calls function(entry) for the entries of a range.
  template <typename Function>
  void ForEach(std::size_t range, const Function& function) const
  {
    if (this->Ranges == 1)
    {
      std::for_each(this->Entries.begin(), this->Entries.end(), function);
      return;
    }
    for (std::size_t part = 0; part < this->Parts; ++part)
    {
      for (const int i : this->Lists[part * this->Ranges + range])
      {
        function(this->Entries[i]);
      }
    }
  }

private:
  const std::vector<SymmetricEntry>& Entries;
  std::size_t Ranges;
  std::size_t Parts;
  std::vector<std::vector<int>> Lists; ///< For each part of the entries a list for each range.
};

/// Assembles the matrix. With `zeroRowSums` the sums of the off-diagonal entries of each row are
/// subtracted from the diagonal.
Eigen::SparseMatrix<double> Assemble(
  Eigen::VectorXd diagonal, const std::vector<SymmetricEntry>& offDiagonal, bool zeroRowSums)
{
  const auto size = static_cast<int>(diagonal.size());
  const EntriesOfRanges entries(size, offDiagonal);
  std::vector<int> next(static_cast<std::size_t>(size), 1);
  ForParts(entries.RangeCount(),
    [&](std::size_t range)
    {
      const auto [begin, end] = PartRange(size, range, entries.RangeCount());
      entries.ForEach(range,
        [&, first = begin, last = end](const SymmetricEntry& entry)
        {
          for (const int column : { entry.row, entry.column })
          {
            if (column >= first && column < last)
            {
              ++next[column];
              diagonal[column] -= zeroRowSums ? entry.value : 0.0;
            }
          }
        });
    });
  Eigen::SparseMatrix<double> matrix(size, size);
  matrix.resizeNonZeros(size + 2 * static_cast<Eigen::Index>(offDiagonal.size()));
  int* const starts = matrix.outerIndexPtr();
  starts[0] = 0;
  for (int column = 0; column < size; ++column)
  {
    int& position = next[column];
    starts[column + 1] = starts[column] + position;
    position = starts[column];
  }
  std::atomic<bool> repeated = false;
  ForParts(entries.RangeCount(),
    [&](std::size_t range)
    {
      const auto [begin, end] = PartRange(size, range, entries.RangeCount());
      int* const rows = matrix.innerIndexPtr();
      double* const values = matrix.valuePtr();
      const auto place = [&](int row, int column, double value)
      {
        const int position = next[column]++;
        rows[position] = row;
        values[position] = value;
      };
      for (int j = begin; j < end; ++j)
      {
        place(j, j, diagonal[j]);
      }
      entries.ForEach(range,
        [&, first = begin, last = end](const SymmetricEntry& entry)
        {
          if (entry.column >= first && entry.column < last)
          {
            place(entry.row, entry.column, entry.value);
          }
          if (entry.row >= first && entry.row < last)
          {
            place(entry.column, entry.row, entry.value);
          }
        });
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

Eigen::SparseMatrix<double> AssembleSymmetric(
  const Eigen::VectorXd& diagonal, const std::vector<SymmetricEntry>& offDiagonal)
{
  return Assemble(diagonal, offDiagonal, false);
}

Eigen::SparseMatrix<double> AssembleZeroRowSums(
  Eigen::Index size, const std::vector<SymmetricEntry>& offDiagonal)
{
  return Assemble(Eigen::VectorXd::Zero(size), offDiagonal, true);
}
}
