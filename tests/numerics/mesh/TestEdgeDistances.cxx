#include "EdgeDistances.h"

#include "Support.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <algorithm>

namespace crossfield::test
{
namespace
{
TEST(EdgeDistances, FindsVerticesAround)
{
  const SurfaceTopology topology(CubedSphere(12));
  const EdgeDistances distances(topology);
  constexpr int Corner = 0; // with three squares of four triangles
  EXPECT_EQ(distances.Around(Corner, 1e-3).size(), 6u);
  for (const double distance : { 0.3, 0.6 })
  {
    const std::vector<int> around = distances.Around(Corner, distance);
    EXPECT_GE(around.size(), 4u) << distance;
    EXPECT_LE(around.size(), 7u) << distance;
    SpacePoint sum = SpacePoint::Zero();
    for (const int vertex : around)
    {
      const SpacePoint offset = topology.PositionOf(vertex) - topology.PositionOf(Corner);
      EXPECT_LT(offset.norm(), 1.5 * distance);
      sum += offset - offset.dot(topology.PositionOf(Corner)) * topology.PositionOf(Corner);
    }
    EXPECT_LT(sum.norm(), 1.5 * distance) << distance; // in all directions
  }
}
}
}
