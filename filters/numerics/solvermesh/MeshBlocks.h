#pragma once

#include "SolverMesh.h"

#include <array>
#include <string>
#include <vector>

namespace crossfield
{
/// Place of a cell in a structured block: column, row and layer; the layer is 0 in two dimensions.
struct BlockPlace
{
  int block = 0;
  std::array<int, 3> index{};
};

/// Returns the blocks of a mesh, given the place of each of its cells. Corner 0 of a cell is at its
/// indices, corner 1 one column further, corner 3 one row further, corner 4 one layer further. Prisms,
/// whose corners 0 and 1 are also 4 and 5, may be turned by the same number of corners in all of a block. Returns none if
/// the cells of a block do not fill it, or neighbours in a block differ in a shared node.
std::vector<MeshBlock> GatherBlocks(const SolverMesh& mesh, const std::vector<BlockPlace>& places);

/// Returns the nodes of a block along an edge: from `start` along a direction to the other end.
std::vector<int> EdgeNodes(const MeshBlock& block, int direction, std::array<int, 3> start);

/// Throws Error unless the blocks have as many cells as the mesh, and points of the mesh at their corners. A mesh
/// without blocks is an Error that calls its format `format`.
void RequireBlocks(const SolverMesh& mesh, const std::string& format);

/// Exchanges the first two indices of left-handed blocks of a valid mesh; in two dimensions only if z is
/// constant, and then z points to the reader.
void OrientBlocks(SolverMesh& mesh);
}
