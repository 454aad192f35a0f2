#pragma once

#include "QuadRequest.h"

namespace crossfield
{
/// Returns the request with the motions of its periodic sides, and with what is prescribed for one side of
/// a pair on the other one, too; a progression is reversed there. Throws Error as FindPairedSides
/// does, and if both sides have different prescriptions.
QuadRequest WithPeriodicSides(const PlanarDomain& domain, const QuadRequest& request);
}
