#pragma once

#include <cstddef>
#include <functional>

namespace crossfield
{
/// Calls function(0) and function(1), in two threads if `parallel` and OpenMP may have as many, and throws what
/// they throw. What is split so has the same two halves however many threads there are, and therefore the same result.
void ForBothHalves(bool parallel, const std::function<void(std::size_t)>& function);
}
