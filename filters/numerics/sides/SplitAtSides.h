#pragma once

#include "BoundarySides.h"
#include "MeshBoundary.h"
#include "SeamlessMap.h"
#include "SidePrescription.h"
#include "TMesh.h"

namespace crossfield
{
/// Adds nodes to a T-mesh (SplitBoundaryArcs) where the quads must have one: where the name of the
/// boundary changes, and at the ends of sides for which something is prescribed.
void SplitAtSides(const SeamlessMap& map, const MeshBoundary& curves, const BoundarySides& sides,
  const SidePrescriptions& prescribed, TMesh& mesh);
}
