#pragma once

#include <cstddef>

namespace crossfield
{
/// A number of an item, 0 or more, as containers of the standard library count.
inline std::size_t Index(int i)
{
  return static_cast<std::size_t>(i);
}
}
