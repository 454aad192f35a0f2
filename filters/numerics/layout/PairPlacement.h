#pragma once

#include "FactoredDomain.h"

#include <array>

namespace crossfield
{
/// Places for a pair of quarter indices 1 and −1 that changes no sum: beside the vertex of the mesh that is farthest from the
/// boundary and the singularities, a third of that distance to either side.
std::array<Point, 2> PlacesForPair(
  const FactoredDomain& domain, const Configuration& configuration);
}
