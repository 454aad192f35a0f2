#pragma once

#include "BoundarySides.h"
#include "MeshBoundary.h"
#include "QuadMesh.h"
#include "TMesh.h"

#include "SeamlessMap.h"

namespace crossfield
{
/// Builds the quad mesh of a T-mesh with edge counts (docs/method.md §14.4): every patch is a
/// lattice of a × b quads, patches share the points on their arcs, and patches of zero width
/// collapse. Points are along arcs in the map as `spacing` has them (ArcSpacing.h), and placed by
/// Coons' formula inside patches; straight paths locate them in the triangles. Boundary points are
/// on the boundary, and the corners of the boundary that are not cones have a point as well.
///
/// Throws Error if the result does not have the Euler characteristic of the domain and the valences
/// of the cones. `sides` are the sides of the domain, whose ends are nodes of the T-mesh
/// (SplitAtSides) where they are fixed.
QuadMesh BuildQuads(const SeamlessMap& map, const MeshBoundary& curves, const TMesh& mesh,
  const std::vector<int>& counts, const std::vector<std::vector<double>>& spacing, double size,
  const BoundarySides& sides = {});
}
