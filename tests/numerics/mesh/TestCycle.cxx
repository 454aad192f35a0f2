#include "Cycle.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "MeshMeasures.h"
#include "Support.h"
#include "UnionFind.h"

namespace crossfield::test
{
namespace
{
/// Expects that each step of a strip enters behind the exit of the one before, and that the cut
/// function jumps across these sides, from 1 on the left to 0 on the right.
void ExpectStrip(const Cycle& cycle, const EdgeNumbering& edges)
{
  ASSERT_FALSE(cycle.steps.empty());
  for (std::size_t s = 0; s < cycle.steps.size(); ++s)
  {
    const Cycle::Step& step = cycle.steps[s];
    const Eigen::Vector3d left = step.Left();
    for (int side = 0; side < 3; ++side)
    {
      // On entry the left end is the start of the side, on exit it is the end.
      const double jump = left[side] - left[(side + 1) % 3];
      EXPECT_EQ(jump, side == step.entry ? 1.0 : side == step.exit ? -1.0 : 0.0);
    }
    const bool isLast = s + 1 == cycle.steps.size();
    if (!isLast || cycle.IsClosed())
    {
      const Cycle::Step& next = cycle.steps[isLast ? 0 : s + 1];
      EXPECT_EQ(edges.Neighbour(step.triangle, step.exit), next.triangle);
      EXPECT_EQ(
        edges.ofTriangle[step.triangle][step.exit], edges.ofTriangle[next.triangle][next.entry]);
    }
  }
}

/// A torus, as a grid of n × n quads that are cut into triangles.
TriangleMesh Torus(int n)
{
  TriangleMesh mesh;
  mesh.points.assign(n * n, Point::Zero());
  const auto at = [n](int i, int j) { return (i % n) * n + j % n; };
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < n; ++j)
    {
      mesh.triangles.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1) });
      mesh.triangles.push_back({ at(i, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return mesh;
}

/// Joins two surfaces along a triangle of each, which is removed.
TriangleMesh Joined(TriangleMesh mesh, const TriangleMesh& other)
{
  const auto gate = mesh.triangles.back();
  mesh.triangles.pop_back();
  const auto& image = other.triangles.front();
  std::vector<int> number;
  for (int v = 0; v < static_cast<int>(other.points.size()); ++v)
  {
    const auto found = std::find(image.begin(), image.end(), v) - image.begin();
    number.push_back(found < 3 ? gate[2 - found] : static_cast<int>(mesh.points.size()));
    if (found == 3)
    {
      mesh.points.push_back(other.points[v]);
    }
  }
  for (std::size_t t = 1; t < other.triangles.size(); ++t)
  {
    const auto& v = other.triangles[t];
    mesh.triangles.push_back({ number[v[0]], number[v[1]], number[v[2]] });
  }
  return mesh;
}

/// Removes a triangle, whose sides become a loop.
void RemoveTriangle(TriangleMesh& mesh, std::size_t triangle, BoundaryKind kind)
{
  const auto v = mesh.triangles[triangle];
  mesh.triangles.erase(mesh.triangles.begin() + triangle);
  for (int i = 0; i < 3; ++i)
  {
    mesh.boundary.push_back({ { v[(i + 1) % 3], v[i] }, kind, static_cast<int>(kind), 0 });
  }
}

/// Returns whether vertices can be divided in two sets so that exactly the edges given join both.
bool AreBorder(const std::vector<bool>& chosen, const EdgeNumbering& edges, int vertexCount)
{
  UnionFind sets(2 * vertexCount); // a vertex in the one set, and in the other
  for (int e = 0; e < edges.Count(); ++e)
  {
    const auto [a, b] = edges.vertices[e];
    const int swap = chosen[e] ? vertexCount : 0;
    sets.Join(a, b + swap);
    sets.Join(a + vertexCount, (b + vertexCount + swap) % (2 * vertexCount));
  }
  for (int v = 0; v < vertexCount; ++v)
  {
    if (sets.Find(v) == sets.Find(v + vertexCount))
    {
      return false;
    }
  }
  return true;
}

/// Expects 2g independent closed strips after those between loops.
void ExpectGenus(int genus, const TriangleMesh& mesh)
{
  const EdgeNumbering edges = NumberEdges(mesh);
  const std::vector<BoundaryLoop> loops = FindBoundaryLoops(mesh);
  const std::vector<Cycle> cycles = FindCycles(mesh, edges, loops);
  const std::size_t open = loops.empty() ? 0 : loops.size() - 1;
  ASSERT_EQ(cycles.size(), open + 2 * genus);
  for (std::size_t k = 0; k < cycles.size(); ++k)
  {
    EXPECT_EQ(cycles[k].IsClosed(), k >= open);
    ExpectStrip(cycles[k], edges);
  }
  // No sum of some of them separates the surface: they are independent modulo 2.
  for (int sum = 1; sum < 1 << cycles.size(); ++sum)
  {
    std::vector<bool> crossed(edges.Count(), false);
    for (std::size_t k = 0; k < cycles.size(); ++k)
    {
      if ((sum >> k) % 2 == 1)
      {
        for (const Cycle::Step& step : cycles[k].steps)
        {
          crossed[edges.ofTriangle[step.triangle][step.exit]].flip();
        }
        if (!cycles[k].IsClosed())
        {
          crossed[edges.ofBoundary[cycles[k].firstBoundaryEdge]].flip();
        }
      }
    }
    EXPECT_FALSE(AreBorder(crossed, edges, static_cast<int>(mesh.points.size())));
  }
}

TEST(Cycle, ConnectsTheOuterLoopToEachOtherLoop)
{
  Random random(100);
  const PlanarDomain domain = MakePlanarDomain({ RegularPolygon(24),
    RegularPolygon(3, 0.2, Point(0.4, 0.1)), RegularPolygon(12, 0.2, Point(-0.4, 0.1)) });
  const TriangleMesh mesh = Renumber(DrillHoles(domain, { { { 0.0, -0.5 }, 1, 0.1 } }), random);
  const EdgeNumbering edges = NumberEdges(mesh);
  const std::vector<BoundaryLoop> loops = FindBoundaryLoops(mesh);
  const std::vector<Cycle> cycles = FindCycles(mesh, edges, loops);
  ASSERT_EQ(cycles.size(), 3u);
  for (std::size_t k = 0; k < cycles.size(); ++k)
  {
    const Cycle& cycle = cycles[k];
    ExpectStrip(cycle, edges);
    const auto expectEnd = [&](int boundaryEdge, const BoundaryLoop& loop, int triangle, int side)
    {
      EXPECT_EQ(mesh.boundary[boundaryEdge].kind, loop.kind);
      EXPECT_EQ(mesh.boundary[boundaryEdge].id, loop.id);
      EXPECT_EQ(edges.ofBoundary[boundaryEdge], edges.ofTriangle[triangle][side]);
    };
    const Cycle::Step& first = cycle.steps.front();
    const Cycle::Step& last = cycle.steps.back();
    expectEnd(cycle.firstBoundaryEdge, loops[0], first.triangle, first.entry);
    expectEnd(cycle.lastBoundaryEdge, loops[k + 1], last.triangle, last.exit);
  }
}

TEST(Cycle, IsAbsentInADisk)
{
  const TriangleMesh mesh = DrillHoles(Builtin("disk"), {});
  EXPECT_TRUE(FindCycles(mesh, NumberEdges(mesh), FindBoundaryLoops(mesh)).empty());
}

TEST(Cycle, RefusesALoopThatCannotBeReached)
{
  TriangleMesh mesh = DrillHoles(Builtin("disk"), {});
  const TriangleMesh part = DrillHoles(Builtin("square"), {});
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), part.points.begin(), part.points.end());
  for (const auto& v : part.triangles)
  {
    mesh.triangles.push_back({ v[0] + first, v[1] + first, v[2] + first });
  }
  for (const BoundaryEdge& edge : part.boundary)
  {
    mesh.boundary.push_back(
      { { edge.vertices[0] + first, edge.vertices[1] + first }, BoundaryKind::Inner, 1, 0 });
  }
  EXPECT_TRUE(Refuses([&] { FindCycles(mesh, NumberEdges(mesh), FindBoundaryLoops(mesh)); },
    { "A part of the mesh has no outer boundary loop" }));
}

TEST(Cycle, GeneratesThoseOfClosedSurfacesAndOfSurfacesWithLoops)
{
  Random random(101);
  TriangleMesh surface = Torus(5);
  for (int genus = 1; genus <= 3; ++genus)
  {
    ExpectGenus(genus, Renumber(surface, random));
    TriangleMesh open = surface;
    RemoveTriangle(open, 20, BoundaryKind::Outer);
    ExpectGenus(genus, Renumber(open, random));
    RemoveTriangle(open, 3, BoundaryKind::Inner);
    ExpectGenus(genus, Renumber(open, random));
    surface = Joined(surface, Torus(5));
  }
}
}
}
