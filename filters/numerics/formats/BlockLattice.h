#pragma once

#include "ExportMesh.h"

#include <array>
#include <cstddef>
#include <string>

namespace crossfield
{
/// Returns the place of a point in the nodes of a block, given its indices.
std::size_t BlockPoint(const ExportBlock& block, const std::array<int, 3>& index);

/// Throws Error unless the blocks have as many cells as the mesh, and points of the mesh at their corners. A mesh
/// without blocks is an Error that calls its format `format`.
void RequireBlocks(const ExportMesh& mesh, const std::string& format);

/// Exchanges the first two indices of left-handed blocks of a valid mesh; in two dimensions only if z is
/// constant, and then z points to the reader.
void OrientBlocks(ExportMesh& mesh);
}
