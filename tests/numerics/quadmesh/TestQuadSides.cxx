// Sides of the boundary: their names follow the boundary through orientation, nesting, simplification
// and meshing, and quads have a node wherever the name changes.

#include "QuadSides.h"

#include "MakePlanarDomain.h"
#include "QuadWorkflow.h"
#include "RandomSides.h"
#include "Support.h"
#include "ThinBoundary.h"

#include <algorithm>
#include <set>

namespace crossfield::test
{
namespace
{
/// Returns the distance of the nearest node of the boundary.
double DistanceToNode(const QuadMesh& mesh, const Point& place)
{
  double nearest = std::numeric_limits<double>::infinity();
  for (const QuadPoint& point : mesh.points)
  {
    if (point.curve.loop >= 0)
    {
      nearest = std::min(nearest, (point.InPlane() - place).norm());
    }
  }
  return nearest;
}

/// Expects a node at every change of names, and every edge on the side of its midpoint.
void ExpectSides(const PlanarDomain& domain, const BoundarySides& sides, const QuadMesh& mesh)
{
  for (const Point& place : sides.FixedPlaces())
  {
    EXPECT_LE(DistanceToNode(mesh, place), 1e-12 * domain.Diagonal());
  }
  ASSERT_EQ(mesh.sideNames, sides.names);
  std::vector<LoopArc> arcs(domain.loops.begin(), domain.loops.end());
  const SidesAlong along(sides, arcs);
  std::vector<int> edges(sides.names.size(), 0);
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    const auto at = [&](std::size_t end)
    { return mesh.points[static_cast<std::size_t>(edge.points[end])]; };
    std::size_t loop = 0;
    while (arcs[loop].Find(at(0).InPlane(), 1e-9) < 0.0)
    {
      ++loop;
    }
    const double from = arcs[loop].Nearest(at(0).InPlane());
    double length = arcs[loop].Nearest(at(1).InPlane()) - from;
    length += length < 0.0 ? arcs[loop].Length() : 0.0;
    EXPECT_EQ(edge.side, along.At(loop, from + 0.5 * length));
    ++edges[static_cast<std::size_t>(edge.side)];
  }
  for (std::size_t side = 0; side < edges.size(); ++side)
  {
    std::size_t inPieces = 0;
    for (const std::vector<int>& piece : PiecesOf(mesh, static_cast<int>(side)))
    {
      inPieces += piece.size() - 1;
    }
    EXPECT_EQ(inPieces, static_cast<std::size_t>(edges[side]));
  }
}
}

TEST(BoundarySides, SplitsLoopsAtCornersWithoutNames)
{
  const PlanarDomain domain = MakePlanarDomain({ { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } },
    RegularPolygon(40, 0.5, { 2, 2 }), { { 1, 1 }, { 1.2, 1 }, { 1.1, 1.1 } } });
  const BoundarySides sides = NameSides(domain);
  EXPECT_EQ(sides.names,
    (std::vector<std::string>{
      "outer0", "outer1", "outer2", "outer3", "hole0", "hole1", "hole2", "hole3" }));
  EXPECT_EQ(sides.given, 0);
  EXPECT_TRUE(sides.FixedPlaces().empty());
}

TEST(BoundarySides, GeneratesNamesThatAreNotGiven)
{
  const PlanarDomain square = MakePlanarDomain({ { { 0, 0 }, { 4, 0 }, { 4, 4 }, { 0, 4 } } });
  const BoundarySides sides = NameSides(square, { { "outer0", "", "", "b" } });
  EXPECT_EQ(sides.names, (std::vector<std::string>{ "outer0", "b", "outer1", "outer2" }));
  EXPECT_EQ(sides.given, 2);
  // one fixed place at each end of a name
  EXPECT_EQ(sides.FixedPlaces().size(), 3U);
}

TEST(BoundarySides, StayWhenTheBoundaryIsThinned)
{
  Random random(11);
  for (int run = 0; run < 20; ++run)
  {
    const PlanarDomain domain = RandomSmoothDomain(random, 2000);
    const BoundarySides sides = NameSides(domain, RandomNames(random, domain, 7));
    const PlanarDomain thin = ThinBoundary(domain, 0.05, sides.FixedPlaces()).domain;
    ASSERT_LT(thin.loops[0].size(), domain.loops[0].size());
    const LoopArc before(domain.loops[0]);
    const LoopArc after(thin.loops[0]);
    const SidesAlong alongBefore(sides, { before });
    const SidesAlong alongAfter(sides, { after });
    for (std::size_t i = 0; i < thin.loops[0].size(); ++i)
    {
      const Point middle = after.At(0.5 * (after.Start(i) + after.Start(i + 1)));
      EXPECT_EQ(alongAfter.At(0, 0.5 * (after.Start(i) + after.Start(i + 1))),
        alongBefore.At(0, before.Nearest(middle)));
    }
    for (const Point& place : sides.FixedPlaces())
    {
      EXPECT_EQ(std::count(thin.loops[0].begin(), thin.loops[0].end(), place), 1);
    }
  }
}

TEST(QuadSides, RandomPartsHaveANodeAtEveryChangeOfNames)
{
  Random random(2);
  for (int run = 0; run < 25; ++run)
  {
    SCOPED_TRACE(run);
    const PlanarDomain domain = RandomPart(random);
    QuadRequest request;
    request.quadCount = random.Integer(200, 900);
    request.sizing = run % 2 == 0 ? Sizing::Conformal : Sizing::Uniform;
    request.sides = NameSides(domain, RandomNames(random, domain, 6));
    const QuadWorkflowResult result = MakeQuadMesh(domain, request);
    EXPECT_EQ(result.quads.quality.inverted, 0);
    ExpectSides(domain, request.sides, result.quads.mesh);
  }
}

TEST(QuadSides, BlocksHaveTheSidesOfTheirEdges)
{
  const PlanarDomain square = MakePlanarDomain({ { { 0, 0 }, { 2, 0 }, { 2, 1 }, { 0, 1 } } });
  QuadRequest request;
  request.quadSize = 0.25;
  request.sides = NameSides(square, { { "bottom", "right", "top", "left" } });
  const QuadResult quads = MakeQuadMesh(square, request).quads;
  ASSERT_EQ(quads.blocks.blocks.size(), 1U);
  const auto sides = SidesOfBlocks(quads.mesh, quads.blocks.blocks);
  std::set<int> found;
  for (std::size_t side = 0; side < 4; ++side)
  {
    ASSERT_EQ(sides[0][side].size(), 1U);
    const std::vector<int> points = PointsAlong(quads.blocks.blocks[0], side);
    const std::vector<int> piece = PiecesOf(quads.mesh, sides[0][side][0]).front();
    EXPECT_EQ(
      std::set<int>(points.begin(), points.end()), std::set<int>(piece.begin(), piece.end()));
    found.insert(sides[0][side][0]);
  }
  EXPECT_EQ(found.size(), 4U);
}
}
