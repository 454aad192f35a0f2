#pragma once

#include "BoundarySymmetry.h"

namespace crossfield
{
/// Returns the symmetries of the curves of a domain, for positions of singularities, which need them
/// only to 2e-3 of the diagonal: loops that are circles (CircleOf) are compared by their centres and
/// radii, wherever their vertices are, others by the distance of vertices from the other boundary.
/// The group contains that of FindSymmetries, and equals it if all loops are concentric circles.
/// Further rotations by less than 15° are not looked for.
SymmetryGroup FindCurveSymmetries(const PlanarDomain& domain);
}
