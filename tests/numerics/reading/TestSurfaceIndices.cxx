#include "Support.h"
#include "SurfaceIndices.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <cmath>
#include <numeric>

namespace crossfield::test
{
namespace
{
/// Returns crosses along the projections of a direction in space to the triangles.
Eigen::VectorXd Along(const MeshTopology& topology, const SpacePoint& direction)
{
  return AnglesInCharts(
    topology, std::vector<SpacePoint>(topology.mesh.triangles.size(), direction));
}

int SumOf(const std::vector<int>& quarters)
{
  return std::accumulate(quarters.begin(), quarters.end(), 0);
}

TEST(SurfaceIndices, OfMeridiansAreAtThePoles)
{
  // Of index 4 each: crosses turn so fast there that it is spread over some vertices.
  const SurfaceMesh sphere = CubedSphere(12);
  const SurfaceTopology topology(sphere);
  const SpacePoint pole = SpacePoint(0.1, 0.2, 1.0).normalized();
  const std::vector<int> quarters = ReadSurfaceIndices(topology, Along(topology, pole));
  int north = 0;
  int south = 0;
  for (std::size_t v = 0; v < quarters.size(); ++v)
  {
    const bool isNear = sphere.points[v].cross(pole).norm() < 0.25;
    EXPECT_TRUE(isNear || quarters[v] == 0);
    (sphere.points[v].dot(pole) > 0.0 ? north : south) += quarters[v];
  }
  EXPECT_EQ(north, 4);
  EXPECT_EQ(south, 4);
}

TEST(SurfaceIndices, OfAnyFieldAddUp)
{
  Random random(571);
  for (const SurfaceMesh& surface :
    { CubedSphere(5), Hemisphere(6), Torus(2.5, 16, 8), BoxWithHoles(2, 3) })
  {
    const SurfaceTopology topology(surface);
    Eigen::VectorXd angle(topology.TriangleCount());
    for (double& one : angle)
    {
      one = random.Uniform(-Pi, Pi);
    }
    const std::vector<int> quarters = ReadSurfaceIndices(topology, angle);
    const int sum = 4 * topology.edges.EulerCharacteristic(topology.mesh);
    EXPECT_EQ(SumOf(quarters), sum);
    EXPECT_EQ(CountUnwanted(topology, angle, quarters), 0);
    int found = 0;
    for (const VertexSingularity& one : FindSurfaceSingularities(topology, angle, true))
    {
      found += one.quarterIndex;
      EXPECT_NE(one.quarterIndex, 0);
    }
    EXPECT_EQ(found, sum);
  }
}

TEST(SurfaceIndices, OfAFieldAlongTheSidesAreAtItsCorners)
{
  constexpr int N = 6;
  const SurfaceTopology topology(BentAtRandom(GridOfSquare(N), N, 572));
  // Crosses along the first side of each triangle of the grid, which is along x.
  Eigen::VectorXd angle(topology.TriangleCount());
  for (int t = 0; t < topology.TriangleCount(); ++t)
  {
    const auto& v = topology.mesh.triangles[t];
    const int side = v[1] - v[0] == N + 1 ? 0 : 1; // p, p + x
    angle[t] = topology.DirectionOf(t, side);
  }
  const std::vector<int> quarters = ReadSurfaceIndices(topology, angle);
  for (int v = 0; v < static_cast<int>(quarters.size()); ++v)
  {
    const bool isCorner = v == 0 || v == N || v == N * (N + 1) || v == (N + 1) * (N + 1) - 1;
    EXPECT_EQ(quarters[v], isCorner ? 1 : 0) << v;
  }
  EXPECT_EQ(FindSurfaceSingularities(topology, angle, true).size(), 4u);
  EXPECT_TRUE(FindSurfaceSingularities(topology, angle, false).empty());
  std::vector<int> others = quarters;
  others[N + 5] = 1;
  EXPECT_EQ(CountUnwanted(topology, angle, others), 1);
}

TEST(SurfaceIndices, NeedDirectionsAlongTheSurface)
{
  const SurfaceTopology topology(BentAtRandom(GridOfSquare(2), 2, 573));
  EXPECT_TRUE(Refuses([&] { Along(topology, SpacePoint::Zero()); },
    { "The cross on the triangle at (", "no direction" }));
}
}
}
