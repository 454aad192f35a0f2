#pragma once

#include <cstddef>

namespace crossfield
{
/// Converts a non-negative index to the index type of standard containers.
inline std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}
}
