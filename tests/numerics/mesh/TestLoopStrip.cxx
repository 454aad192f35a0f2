#include "DrillHoles.h"
#include "LoopStrip.h"
#include "MakePlanarDomain.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
TEST(LoopStrip, ConnectsTheOuterLoopToEachOtherLoop)
{
  Random random(100);
  const PlanarDomain domain = MakePlanarDomain({ RegularPolygon(24),
    RegularPolygon(3, 0.2, Point(0.4, 0.1)), RegularPolygon(12, 0.2, Point(-0.4, 0.1)) });
  const TriangleMesh mesh = Renumber(DrillHoles(domain, { { { 0.0, -0.5 }, 1, 0.1 } }), random);
  const EdgeNumbering edges = NumberEdges(mesh);
  const std::vector<BoundaryLoop> loops = FindBoundaryLoops(mesh);
  EXPECT_EQ(FindLoopStrips(mesh, edges, loops, false).size(), 2u);
  const std::vector<LoopStrip> strips = FindLoopStrips(mesh, edges, loops, true);
  ASSERT_EQ(strips.size(), 3u);
  for (std::size_t k = 0; k < strips.size(); ++k)
  {
    const LoopStrip& strip = strips[k];
    EXPECT_EQ(mesh.boundary[strip.firstBoundaryEdge].kind, BoundaryKind::Outer);
    EXPECT_EQ(mesh.boundary[strip.lastBoundaryEdge].kind, loops[k + 1].kind);
    EXPECT_EQ(mesh.boundary[strip.lastBoundaryEdge].id, loops[k + 1].id);
    // η jumps across exactly the edges that the strip crosses: between the edge where it enters and
    // the next, it is 1 at the left ends and 0 at the right ends.
    int in = edges.ofBoundary[strip.firstBoundaryEdge];
    for (std::size_t s = 0; s < strip.steps.size(); ++s)
    {
      const int t = strip.steps[s].triangle;
      const int out = s + 1 < strip.steps.size() ? -1 : edges.ofBoundary[strip.lastBoundaryEdge];
      int crossed = 0;
      int next = -1;
      for (int i = 0; i < 3; ++i)
      {
        const double from = strip.steps[s].left[i];
        const double to = strip.steps[s].left[(i + 1) % 3];
        const int edge = edges.ofTriangle[t][i];
        if (from != to)
        {
          ++crossed;
          // On entry the left end is the start of the edge in the orientation of the triangle.
          EXPECT_EQ(from, edge == in ? 1.0 : 0.0);
          next = edge == in ? next : edge;
        }
      }
      EXPECT_EQ(crossed, 2);
      EXPECT_TRUE(out < 0 || next == out);
      if (s + 1 < strip.steps.size())
      {
        const auto& pair = edges.triangles[next];
        EXPECT_EQ(pair[0] == t ? pair[1] : pair[0], strip.steps[s + 1].triangle);
      }
      in = next;
    }
  }
}

TEST(LoopStrip, IsAbsentWithoutOtherLoops)
{
  const TriangleMesh mesh = DrillHoles(Builtin("disk"), { { { 0.0, 0.0 }, 4, 0.1 } });
  const std::vector<BoundaryLoop> loops = FindBoundaryLoops(mesh);
  EXPECT_TRUE(FindLoopStrips(mesh, NumberEdges(mesh), loops, false).empty());
  const TriangleMesh whole = DrillHoles(Builtin("disk"), {});
  EXPECT_TRUE(FindLoopStrips(whole, NumberEdges(whole), FindBoundaryLoops(whole), true).empty());
}
}
}
