#pragma once

#include "SeamlessMap.h"

#include <array>
#include <string>
#include <vector>

namespace crossfield
{
/// Completes the names of the sides of a surface's boundary, per entry of mesh.boundary. Entries without a name are called
/// outer0, outer1, ... on the longest loop and hole0, hole1, ... on the others: a side ends at a corner, which has other
/// than two quads, and where an entry has a name. Loops may lead through several faces, whose vertices at the same place
/// are `twins`. Entries on lines between faces are on no loop. Returns the names in order along the loops.
std::vector<std::string> NameBoundary(const SeamlessMap& map,
  const std::vector<std::array<int, 2>>& twins, const std::vector<bool>& isOnLine,
  std::vector<std::string>& names);
}
