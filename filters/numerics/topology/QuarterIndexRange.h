#pragma once

#include <string>

namespace crossfield
{
/// Largest absolute quarter index. A hole has 8 |k| edges, and the matrix on them is dense: at 1000
/// it takes half a GiB. The sum of as many indices as fit into memory stays below the largest int.
constexpr int MaximumQuarterIndex = 1000;

/// Converts a quarter index given as a floating-point number. Throws Error unless it is an integer
/// of at most MaximumQuarterIndex in absolute value; `what` begins the sentence, `examples` lists
/// valid values.
int RequireQuarterIndex(
  double value, const std::string& what, const std::string& examples = "1 or -1");
}
