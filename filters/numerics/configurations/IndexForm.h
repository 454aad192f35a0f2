#pragma once

#include "StrengthChanges.h"

#include <algorithm>
#include <vector>

namespace crossfield
{
/// Values that an index may have, 0 among them.
struct IndexRange
{
  int lowest = -1;
  int highest = 1;

  bool Contains(int index) const { return this->lowest <= index && index <= this->highest; }
  bool IsEmpty() const { return this->lowest == 0 && this->highest == 0; }
  IndexRange And(const IndexRange& other) const
  {
    return { std::max(this->lowest, other.lowest), std::min(this->highest, other.highest) };
  }
};

/// The form of StrengthChanges in the indices themselves: up to a constant, linear · k + ½ k · matrix k
/// for all k with the sum `total`.
struct IndexForm
{
  StrengthChanges::Form form;
  std::vector<IndexRange> ranges; ///< Of each index.
  int total = 0;
};
}
