#pragma once

#include "TMesh.h"

#include "SeamlessMap.h"

namespace crossfield
{
/// Adds a node to a T-mesh at the start of each given entry of mesh.boundary, where quads must have
/// a point (TNode::isFixed). The arc on the boundary is divided there; no separatrix starts at the
/// node, so it is a T-junction of the one patch beside it. A node that is there already is fixed
/// instead.
void SplitBoundaryArcs(const SeamlessMap& map, const std::vector<int>& positions, TMesh& mesh);
}
