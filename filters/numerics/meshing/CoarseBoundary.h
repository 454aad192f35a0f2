#pragma once

#include "BoundaryCorners.h"

namespace crossfield
{
/// The domain with fewer vertices where its boundary is much finer than a length, for meshes that need
/// not be finer than that. What is left out is within a thousandth of the length of the new sides; these are
/// no longer than it, and turn by at most half of the corner angle along what they stand for. Corners, their
/// neighbours and the vertices of `keep` stay, so corners keep their angles.
///
/// Returns the domain as it is where its loops come so near each other that the new ones would touch.
PlanarDomain CoarsenBoundary(const PlanarDomain& domain, double length, double cornerAngle,
  const std::vector<CornerChoice>& keep);
}
