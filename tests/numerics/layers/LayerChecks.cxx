#include "LayerChecks.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace crossfield::test
{
void ExpectSoundBlocks(const QuadResult& result)
{
  const QuadMesh& mesh = result.mesh;
  std::size_t quads = 0;
  std::size_t boundary = 0;
  for (const QuadBlock& block : result.blocks.blocks)
  {
    quads += static_cast<std::size_t>(block.width * block.height);
    EXPECT_TRUE(
      std::none_of(block.points.begin(), block.points.end(), [](int point) { return point < 0; }));
    for (std::size_t side = 0; side < 4; ++side)
    {
      const BlockNeighbour& neighbour = block.neighbours[side];
      std::vector<int> points = PointsAlong(block, side);
      if (neighbour.block < 0)
      {
        boundary += points.size() - 1;
        EXPECT_TRUE(std::all_of(points.begin(), points.end(),
          [&](int point) { return mesh.points[static_cast<std::size_t>(point)].curve.loop >= 0; }));
        continue;
      }
      if (neighbour.orientation < 0)
      {
        std::reverse(points.begin(), points.end());
      }
      EXPECT_EQ(points,
        PointsAlong(result.blocks.blocks[static_cast<std::size_t>(neighbour.block)],
          static_cast<std::size_t>(neighbour.side)));
    }
  }
  EXPECT_EQ(quads, mesh.quads.size());
  EXPECT_EQ(boundary,
    std::count_if(mesh.boundary.begin(), mesh.boundary.end(),
      [](const QuadBoundaryEdge& edge) { return edge.kind != BoundaryKind::Interface; }));
}
}
