#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace crossfield
{
/// What is beyond a side of a block.
struct BlockNeighbour
{
  int block = -1; ///< −1: the boundary.
  int side = -1;  ///< Of that block.
  int orientation =
    0; ///< 1 where the points of both sides have the same order, −1 where it is reversed.
};

/// A structured part of a quad mesh.
struct QuadBlock
{
  int width = 0;
  int height = 0;
  /// Beyond the sides j = 0, i = width, j = height, i = 0.
  std::array<BlockNeighbour, 4> neighbours;
  std::vector<int> points; ///< Of the mesh, (width + 1) (height + 1), i fastest; right-handed.
};

/// The points of a side, by increasing i or j.
std::vector<int> PointsAlong(const QuadBlock& block, std::size_t side);

/// Finds what is beyond the sides of blocks that meet side to side, by their points.
void FindNeighbours(std::vector<QuadBlock>& blocks);
}
