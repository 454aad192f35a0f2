#pragma once

#include "MeshFaces.h"

#include <array>
#include <vector>

namespace crossfield
{
/// A rectangle of faces of cells, which are edges in two dimensions, on a side of a block.
struct BlockRange
{
  int block = 0;
  int face = 0;               ///< 2 d for the side where index d is 0, 2 d + 1 where it is largest.
  std::array<int, 3> begin{}; ///< Indices of a corner point of the rectangle.
  std::array<int, 3> end{};   ///< Indices of the opposite corner point.
};

/// Two rectangles with the same points.
struct BlockConnection
{
  BlockRange from; ///< `begin` has the smallest indices.
  BlockRange to;   ///< `begin` is the point `begin` of `from`, and `end` is `end`.
  /// Per direction d of the first block, ±(1 + e) where e is the direction of the second block that
  /// continues it, with the sign of the step; 0 for the third in two dimensions. This is Transform of CGNS.
  std::array<int, 3> transform{};
};

/// A rectangle on the boundary.
struct BlockPatch
{
  BlockRange range; ///< `begin` has the smallest indices.
  int side = 0;     ///< Side of the mesh.
};

/// Which sides of blocks meet and what the others are part of.
struct BlockFaces
{
  std::vector<BlockConnection> connections; ///< Each once, also of a block with itself.
  std::vector<BlockPatch> patches;
  std::vector<BlockRange>
    collapsed; ///< Rectangles that are a line or point, as on the axis of a revolution.
};

/// Finds the connections and patches of the blocks of a mesh. Every face of a cell on a side of a block
/// is in one of them; the rectangles are as large as possible from their first corner.
///
/// Blocks are valid (RequireBlocks), and `faces` are those of the mesh. Throws Error if a face belongs to more than
/// two blocks, the boundary of the blocks is not that of the cells, or faces of blocks are twisted.
BlockFaces FindBlockFaces(const SolverMesh& mesh, const MeshFaces& faces);
}
