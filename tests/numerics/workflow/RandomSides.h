#pragma once

#include "BoundarySides.h"
#include "Support.h"

namespace crossfield::test
{
/// Returns a random part: a smooth outline, a rectangle or a polygon with right and other angles, with
/// up to three round or rectangular holes, rotated by any angle.
PlanarDomain RandomPart(Random& random);

/// Returns names for pieces of random lengths, up to `pieces` on each loop, of which two may have the
/// same name. A loop may have one name.
SegmentNames RandomNames(Random& random, const PlanarDomain& domain, int pieces);
}
