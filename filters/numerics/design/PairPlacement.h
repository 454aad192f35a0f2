#pragma once

#include "FactoredDomain.h"

#include <array>

namespace crossfield
{
/// Returns positions for a pair of quarter indices 1 and −1, which does not change the sum: on
/// either side of the mesh vertex farthest from the boundary and the singularities, at a third of
/// that distance.
std::array<Point, 2> PositionsForPair(
  const FactoredDomain& domain, const Configuration& configuration);
}
