// Circles imprinted in a mesh, and single triangles: docs/method.md §3, variants 4 and 5.
#include "DrillHoles.h"
#include "EdgeNumbering.h"
#include "PoincareHopf.h"
#include "Support.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace crossfield::test
{
namespace
{
DrillOptions Options(DrillMode mode, double meshSize)
{
  DrillOptions options;
  options.mode = mode;
  options.meshSize = meshSize;
  return options;
}

double PolygonArea(const PlanarDomain& domain)
{
  double area = 0.0;
  for (const Loop& loop : domain.loops)
  {
    area += SignedArea(loop);
  }
  return area;
}
}

TEST(ImprintedCircles, AreEdgesOfAMeshOfTheWholeDomain)
{
  Random random(401);
  for (int trial = 0; trial < 6; ++trial)
  {
    SCOPED_TRACE(trial);
    const PlanarDomain domain = RandomSmoothDomain(random);
    const Configuration circles = RandomHoles(random, domain, 3);
    const TriangleMesh mesh = DrillHoles(domain, circles, Options(DrillMode::Imprint, 0.1));
    EXPECT_NEAR(MeshArea(mesh), PolygonArea(domain), 1e-12);
    EXPECT_GT(SmallestAngle(mesh), 20.6);
    const EdgeNumbering edges = NumberEdges(mesh);
    EXPECT_EQ(edges.EulerCharacteristic(mesh), 1);
    for (const BoundaryEdge& edge : mesh.boundary)
    {
      EXPECT_EQ(edge.kind, BoundaryKind::Outer);
    }
    const std::vector<BoundaryLoop> loops = FindImprintedLoops(mesh);
    ASSERT_EQ(loops.size(), circles.size());
    int quarters = 0;
    for (std::size_t i = 0; i < loops.size(); ++i)
    {
      const Singularity& circle = circles[i];
      EXPECT_EQ(loops[i].kind, BoundaryKind::ImprintedCircle);
      EXPECT_EQ(loops[i].id, static_cast<int>(i));
      EXPECT_EQ(loops[i].quarterIndex, circle.quarterIndex);
      EXPECT_GE(loops[i].edges.size(), 32u);
      EXPECT_LT((CentreOf(loops[i], mesh) - circle.position).norm(), 1e-12);
      quarters += circle.quarterIndex;
      double turned = 0.0;
      for (const int edge : EdgesOf(loops[i], edges))
      {
        EXPECT_NE(edges.triangles[static_cast<std::size_t>(edge)][1], -1);
      }
      for (const int position : loops[i].edges)
      {
        const auto& [from, to] = mesh.imprinted[static_cast<std::size_t>(position)].vertices;
        const Point a = mesh.points[static_cast<std::size_t>(from)] - circle.position;
        const Point b = mesh.points[static_cast<std::size_t>(to)] - circle.position;
        EXPECT_LE(a.norm(), circle.radius * (1.0 + 1e-12));
        EXPECT_GE(a.norm(), circle.radius * std::cos(Pi / 32.0) - 1e-12);
        EXPECT_LT(Cross(a, b), 0.0) << "the outside is on the left";
        turned += AngleBetween(a, b);
      }
      EXPECT_NEAR(turned, -2.0 * Pi, 1e-9);
    }
    EXPECT_EQ(CountMeshQuarters(PlanarTopology(mesh)).givenInteriorQuarters, quarters);
    EXPECT_TRUE(Identical(mesh, DrillHoles(domain, circles, Options(DrillMode::Imprint, 0.1))));
  }
}

TEST(ImprintedCircles, AreRejectedOnMeshesWithHoles)
{
  const PlanarDomain disk = Builtin("disk", 0.1);
  const DrillOptions options = Options(DrillMode::Imprint, 0.1);
  EXPECT_TRUE(Refuses(
    [&] {
      DrillHoles(disk, { { Point(0.95, 0.0), 1, 0.1 } }, options);
    },
    { "cuts the boundary" }));
  EXPECT_TRUE(Refuses(
    [&] {
      DrillHoles(disk, { { Point(0.1, 0.0), 1, 0.2 }, { Point(-0.1, 0.0), 1, 0.2 } }, options);
    },
    { "overlap" }));
}

TEST(ImprintedCircles, MustBeClosedAndInsideTheMesh)
{
  TriangleMesh mesh = DrillHoles(
    Builtin("disk", 0.2), { { Point(0.0, 0.0), 1, 0.3 } }, Options(DrillMode::Imprint, 0.2));
  TriangleMesh open = mesh;
  open.imprinted.pop_back();
  EXPECT_TRUE(Refuses([&] { FindImprintedLoops(open); }, { "do not form one closed loop" }));
  TriangleMesh twice = mesh;
  twice.imprinted.push_back(twice.imprinted.front());
  EXPECT_TRUE(Refuses([&] { NumberEdges(twice); }, { "imprinted circle" }));
  TriangleMesh outside = mesh;
  outside.imprinted.push_back(outside.boundary.front());
  EXPECT_TRUE(Refuses([&] { NumberEdges(outside); }, { "imprinted circle" }));
}

TEST(SingleTriangles, ContainTheirPoints)
{
  Random random(402);
  const PlanarDomain disk = Builtin("disk", 0.1);
  const TriangleMesh plain = DrillHoles(disk, {}, Options(DrillMode::Perforate, 0.1));
  for (int trial = 0; trial < 20; ++trial)
  {
    Configuration configuration;
    for (int i = 0; i < 3; ++i)
    {
      const double angle = random.Uniform(2.1 * i, 2.1 * i + 1.0);
      configuration.push_back({ random.Uniform(0.3, 0.8) * Point(std::cos(angle), std::sin(angle)),
        random.Integer(0, 1) == 0 ? -1 : 1 });
    }
    const TriangleMesh mesh = DrillHoles(disk, configuration, Options(DrillMode::Triangle, 0.1));
    EXPECT_EQ(mesh.points, plain.points);
    EXPECT_EQ(mesh.triangles, plain.triangles);
    const auto loops = FindImprintedLoops(mesh);
    ASSERT_EQ(loops.size(), 3u);
    for (std::size_t i = 0; i < 3; ++i)
    {
      ASSERT_EQ(loops[i].edges.size(), 3u);
      EXPECT_EQ(loops[i].quarterIndex, configuration[i].quarterIndex);
      for (const int position : loops[i].edges)
      {
        const auto& [from, to] = mesh.imprinted[static_cast<std::size_t>(position)].vertices;
        const Point& a = mesh.points[static_cast<std::size_t>(from)];
        const Point& b = mesh.points[static_cast<std::size_t>(to)];
        EXPECT_LE(Cross(b - a, configuration[i].position - a), 1e-12);
      }
    }
  }
}

TEST(SingleTriangles, RejectIndicesTooLargeForATriangle)
{
  const PlanarDomain disk = Builtin("disk", 0.1);
  const DrillOptions options = Options(DrillMode::Triangle, 0.1);
  const auto drill = [&](const Configuration& configuration)
  { return [&disk, &options, configuration] { DrillHoles(disk, configuration, options); }; };
  EXPECT_TRUE(Refuses(drill({ { Point(0.0, 0.0), 2 } }), { "singularity 1", "1 or -1 only" }));
  EXPECT_TRUE(Refuses(drill({ { Point(0.0, 0.0), 0 } }), { "quarter index 0" }));
  EXPECT_TRUE(Refuses(drill({ { Point(1.2, 0.0), 1 } }), { "outside the domain" }));
  const Point nearEdge = 0.4995 * (disk.loops[0][0] + disk.loops[0][1]);
  EXPECT_TRUE(Refuses(drill({ { nearEdge, 1 } }), { "edge on the boundary" }));
  EXPECT_TRUE(Refuses(
    drill({ { Point(0.3, 0.3), 1 }, { Point(0.3, 0.3001), 1 } }), { "1 at", "2 at", "share" }));
  EXPECT_TRUE(Refuses(drill({ { Point(NAN, 0.0), 1 } }), { "not a finite number" }));
}
}
