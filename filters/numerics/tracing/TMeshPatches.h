#pragma once

#include "TMesh.h"

namespace crossfield
{
/// Faces come from the quarter turns at nodes alone. Throws Error when one has not four right angles,
/// or faces − arcs + nodes is not the Euler characteristic.
TMesh MakeTMesh(const SeamlessMap& map, const TraceGraph& graph);
}
