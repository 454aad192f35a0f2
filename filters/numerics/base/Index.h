#pragma once

#include <cstddef>

namespace crossfield
{
/// Converts a non-negative number for products that may exceed int and comparisons with sizes.
inline std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}
}
