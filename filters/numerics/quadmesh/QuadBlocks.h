#pragma once

#include "QuadBlock.h"
#include "QuadMesh.h"

namespace crossfield
{
/// The blocks of a mesh, and the position of every quad in them.
struct QuadBlocks
{
  std::vector<QuadBlock> blocks;
  std::vector<int> block; ///< Per quad.
  std::vector<int> i;     ///< Column in the block, per quad.
  std::vector<int> j;     ///< Row in the block, per quad.
};

/// Divides a mesh into blocks along the lines of edges that leave its irregular points, each up to
/// the boundary or another irregular point (docs/method.md §14.7). The pieces are rectangles or
/// annuli; an annulus is cut by one more line. Every side of a block is therefore a full side of
/// another block or part of the boundary. The result depends only on the connectivity.
QuadBlocks FindBlocks(const QuadMesh& mesh);

/// Divides the blocks further, along the lines between quads of different regions and along interfaces, and
/// along the lines of edges that leave points where these turn or end.
QuadBlocks FindBlocks(const QuadMesh& mesh, const std::vector<int>& regions);
}
