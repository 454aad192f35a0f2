#pragma once

#include "TMesh.h"

namespace crossfield
{
/// The nodes and arcs of lines and boundary, without faces.
TMesh LayArcs(const FlatMap& map, const TraceGraph& graph);
}
