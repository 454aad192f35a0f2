#pragma once

#include "MeshFaces.h"

#include <vector>

namespace crossfield
{
/// Cuts the blocks of a mesh of hexahedra until they meet in whole faces, each face of a block is in one side
/// or inside, no two edges have the same two ends, and the hexahedra of the corners of blocks are not folded.
///
/// A cut at a node goes through a block from face to face, and so on through the neighbours: it follows a
/// chord of cells. Returns no blocks if there are none, or cells are too coarse for it.
std::vector<MeshBlock> CutBlocks(const SolverMesh& mesh, const MeshFaces& faces);
}
