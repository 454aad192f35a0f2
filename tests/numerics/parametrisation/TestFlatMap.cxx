#include "FlatMapSolve.h"

#include "MeshForPoints.h"
#include "Support.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
FlatMap MapOf(const PlanarDomain& domain, const Configuration& configuration, double meshSize,
  const FlatMapOptions& options = {})
{
  return SolveFlatMap(
    ShareTopology(MeshOnPoints(domain, configuration, meshSize)), configuration, options);
}

const Configuration Four = OnCircle(4, 0.6, Pi / 4.0, 1, 0.0);

/// Largest deviation of a seam or side from what it should be, relative to the extent.
double SeamDefect(const FlatMap& map)
{
  const MeshTopology& topology = *map.topology;
  double largest = 0.0;
  for (int t = 0; t < static_cast<int>(map.corners.size()); ++t)
  {
    for (int side = 0; side < 3; ++side)
    {
      const int edge =
        topology.edges.ofTriangle[static_cast<std::size_t>(t)][static_cast<std::size_t>(side)];
      const auto& two = topology.edges.triangles[static_cast<std::size_t>(edge)];
      const int other = two[0] == t ? two[1] : two[0];
      if (other < 0)
      {
        continue;
      }
      const SeamTransition across = map.Across(t, side);
      const auto& mine = topology.mesh.triangles[static_cast<std::size_t>(t)];
      const auto& theirs = topology.mesh.triangles[static_cast<std::size_t>(other)];
      for (const int corner : { side, (side + 1) % 3 })
      {
        const auto there =
          std::find(theirs.begin(), theirs.end(), mine[static_cast<std::size_t>(corner)]);
        const Point w = map.At(other, static_cast<int>(there - theirs.begin()));
        largest = std::max(largest, (across(map.At(t, corner)) - w).norm());
      }
    }
  }
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    const int edge = topology.EdgeOfBoundary(static_cast<int>(i));
    const int t = topology.edges.triangles[static_cast<std::size_t>(edge)][0];
    const auto& v = topology.mesh.triangles[static_cast<std::size_t>(t)];
    const auto corner = [&](int end)
    {
      return static_cast<int>(std::find(v.begin(), v.end(),
                                topology.mesh.boundary[i].vertices[static_cast<std::size_t>(end)]) -
        v.begin());
    };
    const Point along = map.At(t, corner(1)) - map.At(t, corner(0));
    const Point turned = TurnByQuarters(along, -map.directions[i]);
    EXPECT_GT(turned.x(), 0.0);
    largest = std::max(largest, std::abs(turned.y()));
  }
  return largest / map.Extent();
}

TEST(FlatMap, OfTheDiskWithFour)
{
  const FlatMap map = MapOf(Builtin("disk", 0.05), Four, 0.05);
  EXPECT_LT(SeamDefect(map), 1e-12);
  std::printf("misfit %g extent %g n %zu\n", map.misfit, map.Extent(), map.corners.size());
}
}
}
