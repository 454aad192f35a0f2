#pragma once

#include "PlanarDomain.h"

namespace crossfield
{
/// Orients, nests and checks boundary loops given in any order and orientation.
///
/// Every loop of the result starts at its leftmost point (of several the lowest) and inner loops
/// are sorted by it, so that the same curves give the same domain however they were written down.
/// Throws Error when there is no loop, a loop has fewer than three points or no area, loops cross
/// or touch, a loop lies outside the outer one or inside another inner one.
PlanarDomain MakePlanarDomain(std::vector<Loop> loops);
}
