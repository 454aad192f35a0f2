#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// A structured part of a quad mesh.
struct QuadBlock
{
  int width = 0;
  int height = 0;
  std::vector<int> points; ///< Of the mesh, (width + 1) (height + 1), i fastest; right-handed.
};

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
/// cuts. Blocks and their lattices depend on the quads alone, not on how they were made.
QuadBlocks FindBlocks(const QuadMesh& mesh);
}
