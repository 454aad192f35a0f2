#include "SmoothCrosses.h"

#include "Support.h"
#include "SurfaceIndices.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
TEST(SmoothCrosses, FollowTheSidesOfASquareThatIsBent)
{
  constexpr int N = 8;
  const SurfaceTopology bent(BentAtRandom(GridOfSquare(N), N, 701));
  const Eigen::VectorXd angle = SmoothCrosses(bent);
  for (int t = 0; t < bent.TriangleCount(); ++t)
  {
    // Each triangle has sides along both axes: a right angle is between two of them.
    double nearest = Pi;
    for (int side = 0; side < 3; ++side)
    {
      nearest =
        std::min(nearest, std::abs(WrapAngle(4.0 * (angle[t] - bent.DirectionOf(t, side)))));
    }
    EXPECT_LT(nearest, 1e-9);
  }
}

TEST(SmoothCrosses, HaveTheSingularitiesOfTheFlatMeshWhenItIsBent)
{
  constexpr int N = 12;
  const TriangleMesh mesh = GridOfSquare(N);
  const auto singularitiesOf = [](const SurfaceMesh& surface)
  {
    const SurfaceTopology topology(surface);
    std::vector<std::pair<int, int>> found;
    for (const VertexSingularity& one :
      FindSurfaceSingularities(topology, SmoothCrosses(topology), true))
    {
      found.emplace_back(one.vertex, one.quarterIndex);
    }
    return found;
  };
  SurfaceMesh flat;
  flat.points = InSpace(mesh.points);
  flat.triangles = mesh.triangles;
  const auto expected = singularitiesOf(flat);
  EXPECT_EQ(expected.size(), 4u); // the corners
  EXPECT_EQ(singularitiesOf(BentAtRandom(mesh, N, 702)), expected);
}

TEST(SmoothCrosses, HaveIndicesThatAddUp)
{
  Random random(703);
  for (const int genus : { 0, 1, 2, 4 })
  {
    SurfaceMesh surface = genus == 0 ? CubedSphere(8) : BoxWithHoles(genus, 4);
    for (SpacePoint& point : surface.points)
    {
      point += 0.02 *
        SpacePoint(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    }
    const SurfaceTopology topology(surface);
    int sum = 0;
    for (const VertexSingularity& one :
      FindSurfaceSingularities(topology, SmoothCrosses(topology), true))
    {
      sum += one.quarterIndex;
    }
    EXPECT_EQ(sum, 4 * (2 - 2 * genus));
  }
}
}
}
