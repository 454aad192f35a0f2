#pragma once

#include "TMesh.h"

namespace crossfield
{
/// Builds the T-mesh. Patches follow from the quarter turns at nodes alone. Throws Error when a
/// patch does not have four right angles, or when patches − arcs + nodes is not the Euler
/// characteristic.
TMesh MakeTMesh(const SeamlessMap& map, const TraceGraph& graph);
}
