#include "PlanarTopology.h"
#include "Support.h"

#include <numeric>

namespace crossfield::test
{
namespace
{
TEST(PlanarTopology, TheBoundaryTurnsOnceAroundEveryLoop)
{
  // With the domain on the left, the turning adds up to 2π along the outer loop and −2π along the
  // others; each vertex of a loop is visited once.
  const SharedPlanarTopology topology = ShareTopology(DrillMesh(
    Builtin("ring", 0.1), { { { 0.75, 0.05 }, 1, 0.05 }, { { -0.1, 0.65 }, -1, 0.05 } }, 0.1));
  ASSERT_EQ(topology->loops.size(), 4u);
  EXPECT_EQ(topology->LoopCount(BoundaryKind::Inner), 1);
  EXPECT_EQ(topology->LoopCount(BoundaryKind::Hole), 2);
  for (const BoundaryLoop& loop : topology->loops)
  {
    double sum = 0.0;
    for (const int edge : loop.edges)
    {
      sum += topology->turning[edge];
      const int previous = topology->previous[static_cast<std::size_t>(edge)];
      EXPECT_EQ(topology->BoundaryAt(previous).vertices[1], topology->BoundaryAt(edge).vertices[0]);
      EXPECT_EQ(topology->BoundaryAt(previous).id, loop.id);
    }
    EXPECT_NEAR(sum, loop.kind == BoundaryKind::Outer ? 2.0 * Pi : -2.0 * Pi, 1e-12);
  }
}

TEST(PlanarTopology, AlignedLoopsAreThePolygonsOfTheDomain)
{
  const PlanarDomain domain = Builtin("l-shape");
  const SharedPlanarTopology topology =
    ShareTopology(DrillMesh(domain, { { { 0.2, 0.3 }, 1, 0.05 } }, 0.1));
  const std::vector<Loop> loops = topology->AlignedLoops();
  ASSERT_EQ(loops.size(), 1u);
  EXPECT_NEAR(SignedArea(loops[0]), domain.Area(), 1e-12);
  ASSERT_EQ(topology->alignedVertices[0].size(), loops[0].size());
  for (std::size_t i = 0; i < loops[0].size(); ++i)
  {
    EXPECT_EQ(topology->PointAt(topology->alignedVertices[0][i]), loops[0][i]);
  }
  // Six corners, and none on the hole, although a polygon turns there as well.
  EXPECT_EQ(std::accumulate(topology->corners.begin(), topology->corners.end(), 0), 6);
  for (const Corner& corner : FindCorners(loops))
  {
    const int vertex = topology->VertexOf(corner);
    EXPECT_EQ(topology->PointAt(vertex), corner.position);
    EXPECT_TRUE(topology->corners[static_cast<std::size_t>(vertex)]);
  }
}

TEST(PlanarTopology, RefusesAMeshWithoutAnOuterLoop)
{
  TriangleMesh mesh = DrillMesh(Builtin("square"), {}, 0.3);
  for (BoundaryEdge& edge : mesh.boundary)
  {
    edge.kind = BoundaryKind::Inner;
  }
  EXPECT_TRUE(
    Refuses([&] { PlanarTopology(mesh).FirstOuterEdge(); }, { "no outer boundary loop" }));
}
}
}
