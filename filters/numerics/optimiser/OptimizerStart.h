#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// Moves singularities inside the domain off its boundary and off each other until all distances are
/// 1.2 times the clearance, where the barrier is finite. Returns the clearance that it reached: the one
/// asked for, or half of the least distance of the start where there is no room, as in a gap of two
/// clearances; then nothing is moved. Those on the boundary, outside, or at one place stay. What was symmetric to
/// 1e-9 of the diagonal stays so, if there is room.
double ClearStart(const PlanarDomain& domain, double clearance, Configuration& configuration);
}
