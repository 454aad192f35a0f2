#pragma once

#include "TMesh.h"

#include <cstddef>
#include <vector>

namespace crossfield
{
/// Returns the arcs of one edge that join the same points as another such arc, which happens around a handle and at
/// short lines: the quads there would have the same edge. Arcs on the two sides of patches of zero width are one edge.
std::vector<std::size_t> FindRepeatedEdges(const TMesh& mesh, const std::vector<int>& counts);
}
