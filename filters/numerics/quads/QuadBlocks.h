#pragma once

#include "QuadBlock.h"
#include "QuadMesh.h"

namespace crossfield
{
/// The blocks of a mesh, and where every quad is in them.
struct QuadBlocks
{
  std::vector<QuadBlock> blocks;
  std::vector<int> block; ///< Per quad, and its
  std::vector<int> i;     ///< column
  std::vector<int> j;     ///< and row there.
};

/// Cuts a mesh along the lines of edges that leave its irregular points, each as far as the boundary or
/// another irregular point (docs/method.md §14.7). What is left is rectangles, and annuli, which one more line
/// cuts. So every side of a block is one of another block, or of the boundary. Blocks and their lattices depend on the quads alone, not on how they were made.
QuadBlocks FindBlocks(const QuadMesh& mesh);
}
