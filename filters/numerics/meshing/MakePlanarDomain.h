#pragma once

#include "PlanarDomain.h"

namespace crossfield
{
/// Throws Error if there is no loop, a loop has fewer than three points, a coordinate is not finite, or the extent is out
/// of range (DomainExtent.h).
void RequireLoops(const std::vector<Loop>& loops);

/// Checks, orients and nests boundary loops given in any order and orientation.
///
/// Each loop of the result starts at its leftmost point (the lowest one if there are several), and
/// inner loops are sorted by it. The same curves therefore give the same domain, in whatever order
/// and direction they are given. Throws Error if there is no loop, a loop has fewer than three
/// points or no area, loops cross or touch, or there are several parts (DomainParts.h).
PlanarDomain MakePlanarDomain(std::vector<Loop> loops);
}
