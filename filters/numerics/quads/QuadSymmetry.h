#pragma once

#include "QuadMesh.h"

#include "PlanarDomain.h"

namespace crossfield
{
/// Makes a mesh as symmetric as its domain (docs/method.md §14.5): of the symmetries of the boundary those are kept that
/// take fixed points to fixed points of the same index within 1e-9 of the diagonal and quads to quads, and every
/// other point goes to the mean of what they make of it, on the boundary to the nearest place of the polyline. So it moves
/// by as much as the triangles of the map were not symmetric. Cost: linear in points, times the number of symmetries.
///
/// `released`: singularities inside are not fixed. Returns the number of symmetries, 1 for none.
int MakeSymmetric(
  QuadMesh& mesh, const BoundaryCurves& curves, const PlanarDomain& domain, bool released);
}
