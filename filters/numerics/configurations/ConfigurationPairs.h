#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// Removes pairs of singularities +1 and −1 that are closer to each other than a distance, closest
/// pairs first.
void CancelOpposites(Configuration& configuration, double distance);

/// Replaces the two closest singularities with equal quarter index by one with their sum at the
/// midpoint. Returns false, and does nothing, if there are none or the midpoint is not inside.
bool MergeNearest(const PlanarDomain& domain, Configuration& configuration);

/// Adds a singularity of +1 and one of −1, each at the position farthest from the boundary and from
/// other singularities. Returns false if there is no space.
bool AddPair(const PlanarDomain& domain, Configuration& configuration);
}
