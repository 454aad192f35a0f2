#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// Takes out singularities of ±1 of opposite signs that are nearer to each other than a distance, the
/// nearest first.
void CancelOpposites(Configuration& configuration, double distance);

/// Replaces the two nearest of equal quarter index by one of their sum between them; false, and nothing
/// happens, where there are none, or its place is not inside.
bool MergeNearest(const PlanarDomain& domain, Configuration& configuration);

/// Adds one of +1 and one of −1 where there is most room for each; false where there is none.
bool AddPair(const PlanarDomain& domain, Configuration& configuration);
}
