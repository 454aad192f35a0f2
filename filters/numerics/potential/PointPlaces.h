#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// Throws Error unless singularities lie inside a domain and apart from each other.
void RequirePlaces(const Configuration& configuration, const PlanarDomain& domain);
}
