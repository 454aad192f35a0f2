#pragma once

#include "PlanarDomain.h"

namespace crossfield
{
/// Returns the distance of a loop of a domain to the nearest other loop, infinity if there is none.
double GapAround(const PlanarDomain& domain, std::size_t loop);
}
