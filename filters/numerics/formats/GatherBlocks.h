#pragma once

#include "ExportMesh.h"

#include <array>
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
std::vector<ExportBlock> GatherBlocks(
  const ExportMesh& mesh, const std::vector<BlockPlace>& places);
}
