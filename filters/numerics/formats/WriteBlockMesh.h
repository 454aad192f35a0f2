#pragma once

#include "MeshFaces.h"

#include <string>

namespace crossfield
{
/// First line of system/blockMeshDict.
constexpr const char* BlockMeshNote =
  "// Editable: blockMesh makes as many cells from it, but not the same points.\n";

/// Returns the text of system/blockMeshDict, empty if the blocks of the mesh are not known: the blocks of a mesh
/// of hexahedra and prisms of order 1, cut so that they meet in whole faces (CutBlocks.h), with the numbers of
/// cells, and the patches of FoamMesh.h, of type `patch` if they are cyclic there.
///
/// Along an edge of a block, cells grow geometrically from the first to the last one of the mesh; edges that
/// are not straight are polylines through its nodes. Inside, blockMesh interpolates between the edges of a
/// block. So it makes as many cells, but not the same nodes.
std::string WriteBlockMesh(const SolverMesh& mesh, const MeshFaces& faces);
}
