#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace crossfield
{
/// The neighbour across a side of a block.
struct BlockNeighbour
{
  int block = -1;      ///< −1: the boundary.
  int side = -1;       ///< Side of that block.
  int orientation = 0; ///< 1 if the points of both sides have the same order, −1 if it is reversed.
};

/// A structured block of a quad mesh.
struct QuadBlock
{
  int width = 0;
  int height = 0;
  /// Across the sides j = 0, i = width, j = height, i = 0.
  std::array<BlockNeighbour, 4> neighbours;
  std::vector<int>
    points; ///< Points of the mesh, (width + 1) (height + 1), i fastest; right-handed.
};

/// Returns the points of a side, by increasing i or j.
std::vector<int> PointsAlong(const QuadBlock& block, std::size_t side);

/// Returns the sides of all blocks, as points by increasing i or j. A side that two blocks share is
/// listed once. Requires FindNeighbours.
std::vector<std::vector<int>> SidesOf(const std::vector<QuadBlock>& blocks);

/// Sets the neighbours of blocks that meet side to side, by their points.
void FindNeighbours(std::vector<QuadBlock>& blocks);
}
