#pragma once

#include "TMesh.h"

namespace crossfield
{
/// Builds the nodes and arcs of separatrices and boundary loops, without patches.
TMesh BuildArcs(const SeamlessMap& map, const TraceGraph& graph);
}
