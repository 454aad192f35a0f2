#pragma once

#include "ClearanceBarrier.h"

namespace crossfield
{
/// Moves interior singularities away from the boundary and from each other until all distances are
/// at least 1.2 times the clearance, at edges of the boundary times their factor, where the barrier
/// is finite. Singularities on the boundary,
/// outside, or at the same position are not moved. Symmetries of the configuration to 1e-9 of the
/// diagonal are preserved if space permits.
/// Returns the clearance that was reached: the requested one, or half of the minimum distance of
/// the start if there is not enough space, as in a gap of two clearances; then nothing is moved.
double EnforceClearance(const PlanarDomain& domain, double clearance, Configuration& configuration,
  const ClearanceFactors& factors = {});
}
