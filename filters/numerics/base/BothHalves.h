#pragma once

#include <cstddef>
#include <functional>
#include <utility>

namespace crossfield
{
/// Calls function(0) and function(1), in two threads if `parallel` is set and OpenMP allows more
/// than one thread, and rethrows the first exception.
///
/// Work divided in this way has the same two halves whatever the number of threads, so its results
/// do not depend on that number.
void ForBothHalves(bool parallel, const std::function<void(std::size_t)>& function);

/// Returns the half-open range [begin, end) of indices of one half of `count` items.
inline std::pair<int, int> HalfRange(int count, std::size_t half)
{
  return half == 0 ? std::pair(0, count / 2) : std::pair(count / 2, count);
}

/// Minimum number of simple items that are divided between two threads. With fewer, the threads
/// wait for each other longer than they compute when other programs use the processors, as in an
/// optimiser that solves ten thousand times on a coarse mesh.
constexpr int MinimumParallelCount = 20000;

/// Calls function(begin, end) for both halves of `count` items that are independent of each other.
template <typename Function>
void ParallelForHalves(std::ptrdiff_t count, const Function& function)
{
  ForBothHalves(count >= MinimumParallelCount,
    [&](std::size_t half)
    {
      const auto [begin, end] = HalfRange(static_cast<int>(count), half);
      function(begin, end);
    });
}
}
