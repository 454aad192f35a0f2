#pragma once

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
}
