#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <utility>
#include <vector>

namespace crossfield
{
// Work in parts that run in parallel. The size of a problem determines the parts, never the number
// of threads, and sums of parts are taken in the order of the parts. So the same input gives the
// same result to the last bit, with any number of threads and whichever part is finished first.

/// Calls function(0), …, function(parts − 1), in as many threads as ThreadLimit allows, and returns
/// when all have finished. If calls throw, the exception of the first of these parts is rethrown;
/// the other parts run to their end.
///
/// May be called inside of a part: its parts are then distributed among the same threads. Parts must
/// not report progress, because callbacks need not be safe for several threads.
///
/// Inside of a parallel region of the host, which has divided its work already, everything runs in
/// the calling thread.
void ForParts(std::size_t parts, const std::function<void(std::size_t)>& function);

/// Calls `function`; all threads remain available for the parts inside of it. Without this call the
/// outermost ForParts uses at most as many threads as it has parts.
void WithAllThreads(const std::function<void()>& function);

/// Returns the number of threads in which parts would run here.
int ThreadsOfParts();

/// Minimum number of simple items in a part. With fewer, the threads wait for each other longer than
/// they compute when other programs use the processors, as in an optimiser that solves ten thousand
/// times on a coarse mesh.
constexpr std::ptrdiff_t MinimumPartSize = 10000;
/// Maximum number of parts of a loop: enough for a balanced distribution among 16 threads.
constexpr std::size_t MaximumPartCount = 32;

/// Returns the number of parts of a loop over items: one for each `minimum` items, at least one and
/// at most MaximumPartCount.
inline std::size_t PartCount(std::ptrdiff_t items, std::ptrdiff_t minimum = MinimumPartSize)
{
  return std::clamp<std::size_t>(static_cast<std::size_t>(items / minimum), 1, MaximumPartCount);
}

/// Returns the half-open range [begin, end) of the indices in one of several parts of `items`.
inline std::pair<int, int> PartRange(std::ptrdiff_t items, std::size_t part, std::size_t parts)
{
  const auto bound = [&](std::size_t i)
  {
    return static_cast<int>(
      items * static_cast<std::ptrdiff_t>(i) / static_cast<std::ptrdiff_t>(parts));
  };
  return { bound(part), bound(part + 1) };
}

/// Calls function(begin, end) for ranges that cover `items` items, which are independent of each
/// other.
template <typename Function>
void ForRanges(
  std::ptrdiff_t items, const Function& function, std::ptrdiff_t minimum = MinimumPartSize)
{
  const std::size_t parts = PartCount(items, minimum);
  ForParts(parts,
    [&](std::size_t part)
    {
      const auto [begin, end] = PartRange(items, part, parts);
      function(begin, end);
    });
}

/// Returns the sum of the numbers that function(begin, end) returns for these ranges.
template <typename Function>
double SumOfRanges(
  std::ptrdiff_t items, const Function& function, std::ptrdiff_t minimum = MinimumPartSize)
{
  const std::size_t parts = PartCount(items, minimum);
  std::vector<double> sums(parts);
  ForParts(parts,
    [&](std::size_t part)
    {
      const auto [begin, end] = PartRange(items, part, parts);
      sums[part] = function(begin, end);
    });
  double sum = sums[0];
  for (std::size_t part = 1; part < parts; ++part)
  {
    sum += sums[part];
  }
  return sum;
}
}
