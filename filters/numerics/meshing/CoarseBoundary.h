#pragma once

#include "BoundaryCorners.h"

namespace crossfield
{
/// Removes vertices where the boundary is much finer than a length, for meshes that need not be
/// finer than that.
///
/// Removed vertices are within a thousandth of the length of the new sides. New sides are no longer
/// than the length, and the vertices that they replace turn by at most half of the corner angle in
/// total. Corners, their neighbours and the vertices of `keep` are retained, so corners keep their
/// angles.
///
/// Returns the domain unchanged if its loops are so close to each other that the new ones would
/// touch.
PlanarDomain CoarsenBoundary(const PlanarDomain& domain, double length, double cornerAngle,
  const std::vector<CornerChoice>& keep);
}
