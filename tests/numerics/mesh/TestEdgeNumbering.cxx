#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "Support.h"

#include <algorithm>
#include <set>

namespace crossfield::test
{
namespace
{
/// Returns a square of four triangles around its centre, vertex 4.
TriangleMesh Fan()
{
  TriangleMesh mesh;
  mesh.points = { { 0.0, 0.0 }, { 1.0, 0.0 }, { 1.0, 1.0 }, { 0.0, 1.0 }, { 0.5, 0.5 } };
  mesh.triangles = { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } };
  for (int i = 0; i < 4; ++i)
  {
    mesh.boundary.push_back({ { i, (i + 1) % 4 }, BoundaryKind::Outer, 0, 0 });
  }
  return mesh;
}

std::vector<TriangleMesh> Meshes()
{
  Random random(7);
  std::vector<TriangleMesh> meshes = { Fan(), DrillHoles(Builtin("disk"), {}),
    DrillHoles(Builtin("ring"), OnCircle(4, 0.7, 0.0, 1, 0.05)),
    DrillHoles(Builtin("l-shape"), { { { 0.25, 0.25 }, 1, 0.1 } }) };
  meshes.push_back(Renumber(meshes[2], random));
  return meshes;
}

TEST(EdgeNumbering, NumbersEachEdgeOnceWithItsEndPoints)
{
  for (const TriangleMesh& mesh : Meshes())
  {
    const EdgeNumbering edges = NumberEdges(mesh);
    std::set<std::array<int, 2>> distinct;
    for (const auto& ends : edges.vertices)
    {
      EXPECT_LT(ends[0], ends[1]);
      EXPECT_TRUE(distinct.insert(ends).second);
    }
    const auto joins = [&](int edge, int a, int b) {
      return edges.vertices[edge] == std::array<int, 2>{ std::min(a, b), std::max(a, b) };
    };
    ASSERT_EQ(edges.ofTriangle.size(), mesh.triangles.size());
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    {
      for (std::size_t i = 0; i < 3; ++i)
      {
        ASSERT_TRUE(
          joins(edges.ofTriangle[t][i], mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3]));
      }
    }
    ASSERT_EQ(edges.triangles.size(), edges.vertices.size());
    for (int e = 0; e < edges.Count(); ++e)
    {
      for (const int t : edges.triangles[e])
      {
        if (t >= 0)
        {
          EXPECT_EQ(std::count(edges.ofTriangle[t].begin(), edges.ofTriangle[t].end(), e), 1);
        }
      }
      // Two different triangles, or one on the boundary.
      EXPECT_GE(edges.triangles[e][0], 0);
      EXPECT_NE(edges.triangles[e][0], edges.triangles[e][1]);
      const bool onBoundary = std::count(edges.ofBoundary.begin(), edges.ofBoundary.end(), e) > 0;
      EXPECT_EQ(edges.triangles[e][1] < 0, onBoundary);
    }
    ASSERT_EQ(edges.ofBoundary.size(), mesh.boundary.size());
    for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
    {
      ASSERT_TRUE(
        joins(edges.ofBoundary[i], mesh.boundary[i].vertices[0], mesh.boundary[i].vertices[1]));
    }
    // Each triangle has three edges; each interior edge is shared by two triangles.
    EXPECT_EQ(2 * edges.vertices.size(), 3 * mesh.triangles.size() + mesh.boundary.size());
  }
}

TEST(EdgeNumbering, EulerCharacteristicCountsTheHoles)
{
  const std::vector<TriangleMesh> meshes = Meshes();
  const std::vector<int> expected = { 1, 1, -4, 0, -4 };
  for (std::size_t i = 0; i < meshes.size(); ++i)
  {
    EXPECT_EQ(NumberEdges(meshes[i]).EulerCharacteristic(meshes[i]), expected[i]);
    TriangleMesh more = meshes[i];
    more.points.insert(more.points.end(), 3, Point(7.0, 7.0));
    EXPECT_EQ(NumberEdges(more).EulerCharacteristic(more), expected[i]) << "unused points count";
  }
}

TEST(EdgeNumbering, RefusesMeshesThatAreNotManifold)
{
  TriangleMesh mesh = Fan();
  mesh.points.emplace_back(2.0, 0.5);
  mesh.triangles.push_back({ 1, 5, 4 });
  EXPECT_TRUE(Refuses([&] { NumberEdges(mesh); }, { "More than two triangles", "manifold" }));
}

TEST(EdgeNumbering, RefusesBoundaryLinesThatDoNotFitTheTriangles)
{
  TriangleMesh diagonal = Fan();
  diagonal.boundary.push_back({ { 0, 2 }, BoundaryKind::Outer, 0, 0 });
  EXPECT_TRUE(Refuses([&] { NumberEdges(diagonal); }, { "not an edge of any triangle" }));
  TriangleMesh incomplete = Fan();
  incomplete.boundary.pop_back();
  EXPECT_TRUE(Refuses([&] { NumberEdges(incomplete); }, { "no line cell" }));
}

TEST(FindBoundaryLoops, WalksEveryLoopCounterClockwise)
{
  Random random(8);
  const PlanarDomain domain = MakePlanarDomain(
    { RegularPolygon(4, 2.0), RegularPolygon(5, 0.2), RegularPolygon(3, 0.2, Point(0.7, 0.7)) });
  const Configuration holes = { { { -0.6, -0.6 }, 3, 0.1 }, { { 0.6, -0.5 }, -2, 0.2 } };
  const TriangleMesh mesh = Renumber(DrillHoles(domain, holes), random);
  const std::vector<BoundaryLoop> loops = FindBoundaryLoops(mesh);
  ASSERT_EQ(loops.size(), 5u);
  std::set<int> seen;
  for (const BoundaryLoop& loop : loops)
  {
    // Consecutive edges share the vertex between them, and the last one closes the loop.
    const std::vector<int> vertices = WalkedVertices(mesh, loop);
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const BoundaryEdge& edge = mesh.boundary[loop.edges[i]];
      EXPECT_TRUE(seen.insert(loop.edges[i]).second);
      EXPECT_EQ(edge.vertices[loop.kind == BoundaryKind::Outer ? 1 : 0],
        vertices[(i + 1) % vertices.size()]);
      EXPECT_EQ(edge.kind, loop.kind);
      EXPECT_EQ(edge.id, loop.id);
    }
    EXPECT_GT(SignedArea(WalkedPoints(mesh, loop)), 0.0);
  }
  EXPECT_EQ(seen.size(), mesh.boundary.size());
  // Ordered by kind and id.
  const std::vector<BoundaryKind> kinds = { BoundaryKind::Outer, BoundaryKind::Inner,
    BoundaryKind::Inner, BoundaryKind::Hole, BoundaryKind::Hole };
  const std::vector<int> ids = { 0, 1, 2, 0, 1 };
  const std::vector<int> quarters = { 0, 0, 0, 3, -2 };
  for (std::size_t i = 0; i < loops.size(); ++i)
  {
    EXPECT_EQ(loops[i].kind, kinds[i]);
    EXPECT_EQ(loops[i].id, ids[i]);
    EXPECT_EQ(loops[i].quarterIndex, quarters[i]);
  }
}

TEST(FindBoundaryLoops, RefusesLinesThatDoNotFormOneLoop)
{
  const auto refused = [](const TriangleMesh& mesh, const std::string& kind, const std::string& id)
  {
    return Refuses([&] { FindBoundaryLoops(mesh); },
      { "BoundaryKind " + kind, "BoundaryId " + id, "one closed loop" });
  };
  TriangleMesh open = Fan();
  open.boundary.pop_back();
  EXPECT_TRUE(refused(open, "1", "0"));
  TriangleMesh turned = Fan();
  std::swap(turned.boundary[2].vertices[0], turned.boundary[2].vertices[1]);
  EXPECT_TRUE(refused(turned, "1", "0"));
  TriangleMesh mixed = Fan();
  mixed.boundary[1].kind = BoundaryKind::Hole;
  mixed.boundary[1].id = 9;
  EXPECT_TRUE(Refuses([&] { FindBoundaryLoops(mixed); }, { "one closed loop" }));
  TriangleMesh indices = Fan();
  indices.boundary[3].quarterIndex = 2;
  EXPECT_TRUE(refused(indices, "1", "0"));
  // Two loops with the same id.
  TriangleMesh ring = DrillHoles(Builtin("disk"), OnCircle(2, 0.5, 0.0, 2, 0.1));
  for (BoundaryEdge& edge : ring.boundary)
  {
    edge.id = 0;
  }
  EXPECT_TRUE(refused(ring, "3", "0"));
}
}
}
