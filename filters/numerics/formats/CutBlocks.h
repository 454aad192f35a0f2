#pragma once

#include "ExportMesh.h"

#include <array>
#include <vector>

namespace crossfield
{
/// Returns the node of a block at a column, row and layer.
int NodeAt(const ExportBlock& block, const std::array<int, 3>& index);

/// Returns the nodes of a block along an edge: from `start` along a direction to the other end.
std::vector<int> EdgeNodes(const ExportBlock& block, int direction, std::array<int, 3> start);

/// Sides of the cells of a mesh.
class SidesOfCells
{
public:
  virtual ~SidesOfCells() = default;
  /// Returns the side of the face with these corners, −1 if it is inside.
  virtual int SideOf(const std::array<int, 4>& corners) const = 0;
};

/// Cuts the blocks of a mesh of hexahedra until they meet in whole faces, each face of a block is in one side
/// or inside, no two edges have the same two ends, and the hexahedra of the corners of blocks are not folded.
///
/// A cut at a node goes through a block from face to face, and so on through the neighbours: it follows a
/// chord of cells. Returns no blocks if there are none, or cells are too coarse for it.
std::vector<ExportBlock> CutBlocks(const ExportMesh& mesh, const SidesOfCells& sides);
}
