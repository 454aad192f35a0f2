#pragma once

#include "QuadMesh.h"
#include "TMesh.h"

#include "SeamlessMap.h"

namespace crossfield
{
/// The quad mesh of a T-mesh with counts (docs/method.md §14.4): every face a × b a lattice, points on shared arcs the
/// same, faces without width joined. Its points are even along arcs in the map and by Coons' formula in between,
/// found in the triangles by straight ways; those on the boundary are exactly on its polyline. The corners of the
/// boundary that are no cones have a point, too.
///
/// Throws Error when the result is not a mesh of the domain's Euler characteristic with the valences of the cones.
QuadMesh LayQuads(
  const SeamlessMap& map, const TMesh& mesh, const std::vector<int>& counts, double size);
}
