#pragma once

#include "BoundarySides.h"
#include "MeshBoundary.h"
#include "SeamlessMap.h"
#include "SidePrescription.h"
#include "TMesh.h"

namespace crossfield
{
/// Adds nodes to a T-mesh (SplitBoundaryArcs) where the quads must have one: where the name of the
/// boundary changes, at the ends of sides for which something is prescribed, and at corners that
/// are farther along the boundary from the next ones than quads of a size are long, so that quads
/// do not cut them off.
void SplitAtSides(const SeamlessMap& map, const MeshBoundary& curves, const BoundarySides& sides,
  const SidePrescriptions& prescribed, double size, TMesh& mesh);
}
