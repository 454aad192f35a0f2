#pragma once

#include <Eigen/Core>

#include <cstddef>
#include <functional>
#include <utility>

namespace crossfield
{
/// Calls function(0) and function(1), in two threads if `parallel` and OpenMP may have as many, and throws what
/// they throw. What is split so has the same two halves however many threads there are, and therefore the same result.
void ForBothHalves(bool parallel, const std::function<void(std::size_t)>& function);

/// The first of `count` in either half, and the one behind its last.
inline std::pair<int, int> HalfOf(int count, std::size_t half)
{
  return half == 0 ? std::pair(0, count / 2) : std::pair(count / 2, count);
}

/// How many simple things two threads are taken for. With fewer, the threads wait for each other longer than they compute where other
/// programs want the processors, too: an optimiser that solves ten thousand times on a coarse mesh.
constexpr int FewestToHalve = 20000;

/// function(begin, end) for either half of so many things that are independent of each other.
template <typename Function>
void ForHalvesOf(Eigen::Index count, const Function& function)
{
  ForBothHalves(count >= FewestToHalve,
    [&](std::size_t half)
    {
      const auto [begin, end] = HalfOf(static_cast<int>(count), half);
      function(begin, end);
    });
}
}
