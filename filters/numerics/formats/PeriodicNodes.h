#pragma once

#include "ExportMesh.h"

#include <array>
#include <vector>

namespace crossfield
{
/// Returns for every point of the first side of a pair the point of the second side that the motion takes
/// it to, {first, second} by increasing number of the first. Points inside edges and faces of higher order are included.
///
/// Throws Error if the sides have different numbers of points, a point has no image within 1e-9 of the
/// mesh's extent, and as FindSideFaces does.
std::vector<std::array<int, 2>> PeriodicNodes(const ExportMesh& mesh, const PeriodicPair& pair);
}
