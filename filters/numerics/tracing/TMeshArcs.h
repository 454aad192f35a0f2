#pragma once

#include "TMesh.h"

namespace crossfield
{
/// The nodes and arcs of lines and boundary, without faces.
TMesh LayArcs(const SeamlessMap& map, const TraceGraph& graph);
}
