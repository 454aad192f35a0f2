#include "QuadBlock.h"

#include <algorithm>
#include <map>
#include <utility>

namespace crossfield
{
namespace
{
struct BlockSide
{
  std::size_t block;
  std::size_t side;
  std::vector<int> points;
};

/// Returns a key that is the same for both directions of a side: its ends and the points next to
/// them. The ends alone do not distinguish two sides between the same two corners.
std::array<int, 4> KeyOf(const std::vector<int>& points)
{
  const std::array<int, 4> forward = { points.front(), points[1], points[points.size() - 2],
    points.back() };
  const std::array<int, 4> backward = { forward[3], forward[2], forward[1], forward[0] };
  return std::min(forward, backward);
}
}

std::vector<int> PointsAlong(const QuadBlock& block, std::size_t side)
{
  const bool alongI = side % 2 == 0;
  const int fixed = side == 1 ? block.width : side == 2 ? block.height : 0;
  std::vector<int> points;
  for (int k = 0; k <= (alongI ? block.width : block.height); ++k)
  {
    const int i = alongI ? k : fixed;
    const int j = alongI ? fixed : k;
    points.push_back(block.points[j * (block.width + 1) + i]);
  }
  return points;
}

std::vector<std::vector<int>> SidesOf(const std::vector<QuadBlock>& blocks)
{
  std::vector<std::vector<int>> sides;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    for (std::size_t side = 0; side < 4; ++side)
    {
      const BlockNeighbour& neighbour = blocks[b].neighbours[side];
      const auto own = std::make_pair(static_cast<int>(b), static_cast<int>(side));
      if (neighbour.block < 0 || own < std::make_pair(neighbour.block, neighbour.side))
      {
        sides.push_back(PointsAlong(blocks[b], side));
      }
    }
  }
  return sides;
}

void FindNeighbours(std::vector<QuadBlock>& blocks)
{
  std::map<std::array<int, 4>, BlockSide> open;
  for (std::size_t b = 0; b < blocks.size(); ++b)
  {
    for (std::size_t side = 0; side < 4; ++side)
    {
      const std::vector<int> points = PointsAlong(blocks[b], side);
      const auto found = open.find(KeyOf(points));
      if (found == open.end())
      {
        open.emplace(KeyOf(points), BlockSide{ b, side, points });
        continue;
      }
      const BlockSide& other = found->second;
      const std::vector<int> reversed(points.rbegin(), points.rend());
      const int orientation = points == other.points ? 1 : reversed == other.points ? -1 : 0;
      if (orientation != 0)
      {
        blocks[b].neighbours[side] = { static_cast<int>(other.block), static_cast<int>(other.side),
          orientation };
        blocks[other.block].neighbours[other.side] = { static_cast<int>(b), static_cast<int>(side),
          orientation };
      }
    }
  }
}
}
