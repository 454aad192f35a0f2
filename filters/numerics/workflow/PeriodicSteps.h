#pragma once

#include "ResolvedRequest.h"

namespace crossfield
{
/// Returns a prescription in the other direction, for another side.
SidePrescription Reversed(SidePrescription prescribed, int side);

/// Returns the request with the motions of its periodic sides, and with what is prescribed for one side of
/// a pair on the other one, too; a progression is reversed there. Throws Error as FindPairedSides
/// does, and if both sides have different prescriptions.
ResolvedRequest WithPeriodicSides(const PlanarDomain& domain, const ResolvedRequest& request);
}
