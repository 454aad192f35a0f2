#pragma once

#include "ClearanceBarrier.h"
#include "PlanarDomain.h"

namespace crossfield
{
/// Returns the recommended clearance of singularities for quads of a size: 0.7 of it
/// (docs/method.md §5.6).
double ClearanceForQuads(double quadSize);

/// Number of quads between the boundary of a hole and singularities, where the gap to the next loop
/// permits (docs/method.md §5.10).
constexpr double UsualQuadsAtHoles = 1.5;

/// Returns the factors, at least 1, of ClearanceForQuads at the sides of inner loops, for a distance of
/// a number of quads, but at most one quad less than half of the gap to the nearest other loop.
ClearanceFactors ClearanceAtHoles(
  const PlanarDomain& domain, double quadSize, double quads = UsualQuadsAtHoles);
}
