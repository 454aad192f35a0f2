#include "ArcSpacing.h"
#include "QuadBuilder.h"
#include "Support.h"
#include "SurfaceMap.h"
#include "SurfaceQuads.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"
#include "TMeshPatches.h"
#include "VertexPotential.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace crossfield::test
{
namespace
{
Layout LayOutSurface(const SurfaceMesh& surface, const std::vector<Cone>& cones)
{
  Layout layout;
  layout.map = SolveSurfaceMap(std::make_shared<const SurfaceTopology>(surface), cones);
  layout.separatrices = TraceSeparatrices(layout.map);
  layout.tMesh = MakeTMesh(layout.map, layout.separatrices);
  return layout;
}

TEST(SurfaceQuads, OfTheSphereAreThoseOfACube)
{
  const SurfaceMesh sphere = CubedSphere(12);
  SurfaceQuadOptions options;
  options.quadCount = 600;
  const QuadResult result = MakeSurfaceQuads(LayOutSurface(sphere, ConesOfCube(sphere)), options);
  EXPECT_EQ(result.mesh.quads.size(), 600u);
  EXPECT_EQ(result.blocks.blocks.size(), 6u);
  EXPECT_EQ(result.mesh.EulerCharacteristic(), 2);
  EXPECT_EQ(result.quality.inverted, 0);
  EXPECT_GT(result.quality.jacobian.min, 0.8); // of 0.866
  EXPECT_NEAR(result.quality.bound, std::sin(2.0 * Pi / 3.0), 1e-12);
  for (std::size_t q = 0; q < result.mesh.quads.size(); ++q)
  {
    const auto& quad = result.mesh.quads[q];
    const auto at = [&](std::size_t i) { return result.mesh.points[quad[i]].place; };
    const SpacePoint normal = (at(2) - at(0)).cross(at(3) - at(1));
    EXPECT_GT(normal.dot(at(0)), 0.0); // the outside of the sphere is outside
    EXPECT_GT(normal.dot(result.mesh.normals[q]), 0.0);
  }
}

TEST(SurfaceQuads, OfTheTorusHaveNoIrregularNode)
{
  const Layout layout = LayOutSurface(Torus(2.5, 60, 24), {});
  EXPECT_EQ(layout.tMesh.patches.size(), 1u);
  EXPECT_EQ(layout.tMesh.arcs.size(), 2u);
  SurfaceQuadOptions options;
  options.quadSize = 0.4;
  const QuadResult result = MakeSurfaceQuads(layout, options);
  EXPECT_EQ(result.mesh.EulerCharacteristic(), 0);
  for (const QuadPoint& point : result.mesh.points)
  {
    EXPECT_EQ(point.valence, 4);
  }
  EXPECT_GT(result.quality.jacobian.min, 0.9);
}

TEST(SurfaceQuads, OfAHemisphereHaveOneSide)
{
  const SurfaceMesh half = Hemisphere(12);
  const std::vector<Cone> cones = ConesOfCube(half);
  SurfaceQuadOptions options;
  options.quadCount = 300;
  const QuadResult result = MakeSurfaceQuads(LayOutSurface(half, cones), options);
  EXPECT_EQ(result.mesh.EulerCharacteristic(), 1);
  EXPECT_EQ(result.mesh.sideNames, std::vector<std::string>{ "outer0" });
  for (const QuadBoundaryEdge& edge : result.mesh.boundary)
  {
    EXPECT_EQ(edge.side, 0);
    EXPECT_NEAR(result.mesh.points[edge.points[0]].place.z(), 0.0, 1e-12);
  }
  EXPECT_GE(result.mesh.boundary.size(), 12u);
}

TEST(SurfaceQuads, AreThoseOfThePlaneWhenAMeshIsBent)
{
  constexpr int N = 12;
  const TriangleMesh mesh = GridOfSquare(N);
  const std::vector<Cone> cones = ConesOfSquare(N);
  SurfaceMesh flat;
  flat.points = InSpace(mesh.points);
  flat.triangles = mesh.triangles;
  SurfaceQuadOptions options;
  options.quadSize = 0.04;
  options.smooth = false;
  const QuadResult planar = MakeSurfaceQuads(LayOutSurface(flat, cones), options);
  const QuadResult bent =
    MakeSurfaceQuads(LayOutSurface(BentAtRandom(mesh, N, 556), cones), options);
  EXPECT_EQ(planar.counts.counts, bent.counts.counts);
  EXPECT_EQ(planar.mesh.quads, bent.mesh.quads);
  EXPECT_EQ(
    planar.mesh.sideNames, (std::vector<std::string>{ "outer0", "outer1", "outer2", "outer3" }));
  // Bending keeps the distance along x from the lines and that along y.
  for (std::size_t p = 0; p < planar.mesh.points.size(); ++p)
  {
    EXPECT_EQ(planar.mesh.points[p].triangle, bent.mesh.points[p].triangle);
  }
}

/// Cones at the vertices with curvature.
std::vector<Cone> ConesOfCurvature(const SurfaceMesh& surface)
{
  const SurfaceTopology topology(surface);
  std::vector<Cone> cones;
  for (int vertex = 0; vertex < topology.VertexCount(); ++vertex)
  {
    const auto quarters = static_cast<int>(std::lround(topology.CurvatureAt(vertex) / (0.5 * Pi)));
    if (quarters != 0)
    {
      cones.push_back({ vertex, quarters, false, static_cast<int>(cones.size()) });
    }
  }
  return cones;
}

TEST(SurfaceQuads, OfABoxWithHolesAreItsSquares)
{
  // With an index at each of its corners, H is constant and the map is the surface itself.
  for (const int genus : { 1, 2, 4 })
  {
    const SurfaceMesh box = BoxWithHoles(genus, 2);
    const std::vector<Cone> cones = ConesOfCurvature(box);
    EXPECT_EQ(cones.size(), 8u + 8u * static_cast<std::size_t>(genus));
    const Layout layout = LayOutSurface(box, cones);
    for (const TArc& arc : layout.tMesh.arcs)
    {
      EXPECT_NEAR(arc.length, std::round(arc.length), 1e-9);
    }
    SurfaceQuadOptions options;
    options.quadSize = 1.0;
    const QuadResult result = MakeSurfaceQuads(layout, options);
    EXPECT_NEAR(static_cast<double>(result.mesh.quads.size()), layout.map.topology->Area(), 1e-9);
    EXPECT_EQ(result.mesh.EulerCharacteristic(), 2 - 2 * genus);
    EXPECT_NEAR(result.quality.jacobian.min, 1.0, 1e-6);
  }
}

TEST(SurfaceQuads, KeepHandlesOpenWhenTheyAreLarge)
{
  for (const int genus : { 1, 2, 4 })
  {
    const SurfaceMesh box = BoxWithHoles(genus, 2);
    const Layout layout = LayOutSurface(box, ConesOfCurvature(box));
    for (const double size : { 1.7, 2.5, 4.0, 10.0 })
    {
      SurfaceQuadOptions options;
      options.quadSize = size;
      const QuadResult result = MakeSurfaceQuads(layout, options);
      EXPECT_EQ(result.mesh.EulerCharacteristic(), 2 - 2 * genus) << size;
    }
  }
  const Layout torus = LayOutSurface(Torus(2.5, 30, 12), {});
  for (const double size : { 2.0, 10.0, 100.0 })
  {
    SurfaceQuadOptions options;
    options.quadSize = size;
    EXPECT_EQ(MakeSurfaceQuads(torus, options).mesh.EulerCharacteristic(), 0) << size;
  }
}

TEST(SurfaceQuads, OfRandomSingularitiesOnATorusHaveTheirValences)
{
  // Random positions, of which those are taken whose crosses nearly close up.
  const auto topology = std::make_shared<const SurfaceTopology>(Torus(2.5, 60, 24));
  const VertexPotential potential(topology);
  Random random(559);
  int made = 0;
  for (int trial = 0; trial < 20000 && made < 5; ++trial)
  {
    std::vector<Cone> cones;
    std::set<int> taken;
    while (cones.size() < 6)
    {
      const int vertex = random.Integer(0, topology->VertexCount() - 1);
      if (taken.insert(vertex).second)
      {
        const auto number = static_cast<int>(cones.size());
        cones.push_back({ vertex, number % 2 == 0 ? 1 : -1, false, number });
      }
    }
    const std::vector<double> defect =
      potential.Solve(QuartersOfVertices(*topology, cones)).holonomyDefect;
    if (std::max(std::abs(defect[0]), std::abs(defect[1])) > 0.1)
    {
      continue;
    }
    ++made;
    Layout layout;
    layout.map = SolveSurfaceMap(topology, cones);
    layout.separatrices = TraceSeparatrices(layout.map);
    layout.tMesh = MakeTMesh(layout.map, layout.separatrices);
    SurfaceQuadOptions options;
    options.quadCount = 500 << made % 3;
    const QuadResult result = MakeSurfaceQuads(layout, options);
    EXPECT_EQ(result.mesh.EulerCharacteristic(), 0);
    for (const QuadPoint& point : result.mesh.points)
    {
      EXPECT_EQ(point.valence, 4 - point.quarterIndex);
    }
  }
  EXPECT_EQ(made, 5);
}

/// Returns smooth quads of a planar mesh with given edge counts, of a size.
QuadMesh PlanarQuads(const TriangleMesh& mesh, const std::vector<Cone>& cones,
  const std::vector<int>& counts, double size)
{
  const SharedPlanarTopology topology = ShareTopology(mesh);
  const SeamlessMap map = SolveSurfaceMap(topology, cones);
  const TMesh tMesh = MakeTMesh(map, TraceSeparatrices(map));
  const MeshBoundary curves(*topology);
  QuadMesh quads = BuildQuads(map, curves, tMesh, counts, EqualSpacing(tMesh, counts), size);
  SmoothQuads(quads, FindBlocks(quads), { curves }, std::nullopt, false);
  return quads;
}

TEST(SurfaceQuads, AreSmoothedAsInThePlane)
{
  constexpr int N = 12;
  const TriangleMesh mesh = GridOfSquare(N);
  const std::vector<Cone> cones = ConesOfSquare(N);
  for (const double size : { 0.04, 0.01 }) // without and with coarser meshes
  {
    SurfaceQuadOptions options;
    options.quadSize = size;
    const QuadResult turned =
      MakeSurfaceQuads(LayOutSurface(BentAtRandom(mesh, N, 0, 0.0), cones), options);
    const QuadMesh planar = PlanarQuads(mesh, cones, turned.counts.counts, size);
    ASSERT_EQ(planar.quads, turned.mesh.quads);
    const Eigen::Matrix3d turn = TurnOfBent();
    double largest = 0.0;
    for (std::size_t p = 0; p < planar.points.size(); ++p)
    {
      largest =
        std::max(largest, (turn * planar.points[p].place - turned.mesh.points[p].place).norm());
    }
    EXPECT_LT(largest, 1e-8);
    EXPECT_LT(turned.quality.surface->maximumDistance, 1e-14);
    EXPECT_NEAR(turned.quality.surface->minimumJacobian, turned.quality.jacobian.min, 1e-12);
    const QuadResult bent =
      MakeSurfaceQuads(LayOutSurface(BentAtRandom(mesh, N, 605, 0.1), cones), options);
    EXPECT_EQ(planar.quads, bent.mesh.quads);
    EXPECT_GT(bent.quality.jacobian.min, turned.quality.jacobian.min - 0.02);
  }
}

TEST(SurfaceQuads, AreSmoothWhereverTheirPointsStart)
{
  SurfaceMesh surface = CubedSphere(12);
  const std::vector<Cone> cones = ConesOfCube(surface);
  for (SpacePoint& point : surface.points)
  {
    point = point.cwiseProduct(SpacePoint(1.6, 1.0, 0.8));
  }
  SurfaceQuadOptions options;
  options.quadCount = 1000;
  const Layout layout = LayOutSurface(surface, cones);
  const QuadResult result = MakeSurfaceQuads(layout, options);
  const SurfaceWalk walk(*layout.map.topology);
  QuadMesh mesh = result.mesh;
  Random random(606);
  for (QuadPoint& point : mesh.points)
  {
    if (!point.fixed)
    {
      const MeshPlace place = walk.Find(point.triangle, point.place);
      const double reach = 0.4 * result.size;
      const Point step(random.Uniform(-reach, reach), random.Uniform(-reach, reach));
      const MeshPlace moved = walk.Walk(place, AxesOf(walk.NormalAt(place)) * step);
      point.triangle = moved.triangle;
      point.place = walk.PlaceOf(moved);
    }
  }
  EXPECT_LT(MeasureQuads(mesh, result.size).jacobian.min, 0.0);
  const MeshBoundary none(*layout.map.topology);
  SmoothQuads(mesh, result.blocks, { none, &walk }, std::nullopt, false);
  double largest = 0.0;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    const QuadPoint& point = mesh.points[p];
    const MeshPlace place = walk.Find(point.triangle, point.place);
    EXPECT_LT((walk.PlaceOf(place) - point.place).norm(), 1e-12); // on the surface
    largest = std::max(largest, (point.place - result.mesh.points[p].place).norm());
  }
  EXPECT_LT(largest, 0.05 * result.size);
}

TEST(SurfaceQuads, OfCoarserMeshesRestrictByTheTransposeOfProlongation)
{
  const SurfaceMesh half = Hemisphere(12);
  const Layout layout = LayOutSurface(half, ConesOfCube(half));
  SurfaceQuadOptions options;
  options.quadCount = 3000;
  const QuadResult result = MakeSurfaceQuads(layout, options);
  const MeshBoundary curves(*layout.map.topology);
  const SurfaceWalk walk(*layout.map.topology);
  const std::vector<QuadLattice> lattices = LatticesOf(result.mesh, result.blocks);
  const CoarseQuads coarse(result.mesh, lattices);
  const TangentFrames fine(result.mesh, &walk);
  const TangentFrames frames(coarse.mesh, &walk);
  Random random(607);
  const auto randomFor = [&random](const QuadMesh& mesh)
  {
    Eigen::VectorXd vector(2 * static_cast<Eigen::Index>(mesh.points.size()));
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      vector.segment<2>(2 * static_cast<Eigen::Index>(p)) << random.Uniform(-1.0, 1.0),
        mesh.points[p].curve.loop < 0 ? random.Uniform(-1.0, 1.0) : 0.0;
    }
    return vector;
  };
  const Eigen::VectorXd moves = randomFor(coarse.mesh);
  const Eigen::VectorXd gradient = randomFor(result.mesh);
  EXPECT_NEAR(coarse.Prolong(curves, fine, frames, moves).dot(gradient),
    moves.dot(coarse.Restrict(curves, fine, frames, gradient)),
    1e-12 * moves.norm() * gradient.norm());
}

TEST(SurfaceQuads, AreAsFarFromASphereAsTheirChords)
{
  const SurfaceMesh sphere = CubedSphere(24);
  SurfaceQuadOptions options;
  options.quadCount = 600;
  const QuadResult result = MakeSurfaceQuads(LayOutSurface(sphere, ConesOfCube(sphere)), options);
  const SurfaceQuality& quality = *result.quality.surface;
  // The centre of a square with side h is h² / 4 below a sphere of radius 1.
  EXPECT_NEAR(quality.meanDistance, 0.25 * 4.0 * Pi / 600.0, 0.1 * quality.meanDistance);
  EXPECT_LT(quality.maximumDistance, 1.6 * quality.meanDistance);
  EXPECT_EQ(quality.bent, 0);
  options.quadCount = 24;
  EXPECT_GT(MakeSurfaceQuads(LayOutSurface(sphere, ConesOfCube(sphere)), options)
              .quality.surface->maximumDistance,
    0.1);
}

TEST(SurfaceQuads, CountThoseWithinWhichTheSurfaceTurns)
{
  const SurfaceMesh box = BoxWithHoles(1, 4);
  SurfaceQuadOptions options;
  options.quadSize = 0.5;
  const QuadResult result = MakeSurfaceQuads(LayOutSurface(box, ConesOfCurvature(box)), options);
  EXPECT_GT(result.quality.surface->bent, 0); // at its edges
  EXPECT_GT(result.quality.jacobian.min, 0.99);
}

TEST(SurfaceQuads, HaveSidesBetweenCorners)
{
  // The upper side of a box with a hole: a square in a square.
  SurfaceMesh sheet;
  const SurfaceMesh box = BoxWithHoles(1, 3);
  std::vector<int> number(box.points.size(), -1);
  for (auto triangle : box.triangles)
  {
    if (std::any_of(triangle.begin(), triangle.end(),
          [&box](int vertex) { return box.points[vertex].z() < 1.0; }))
    {
      continue;
    }
    for (int& vertex : triangle)
    {
      int& own = number[vertex];
      if (own < 0)
      {
        own = static_cast<int>(sheet.points.size());
        sheet.points.push_back(box.points[vertex]);
      }
      vertex = own;
    }
    sheet.triangles.push_back(triangle);
  }
  const SurfaceTopology topology(sheet);
  std::vector<Cone> cones;
  for (int i = 0; i < static_cast<int>(topology.turning.size()); ++i)
  {
    const auto quarters = static_cast<int>(std::lround(topology.turning[i] / (0.5 * Pi)));
    if (quarters != 0)
    {
      cones.push_back({ topology.BoundaryAt(i).vertices[0], quarters, true, -1 });
    }
  }
  ASSERT_EQ(cones.size(), 8u);
  SurfaceQuadOptions options;
  options.quadSize = 0.25;
  const QuadMesh mesh = MakeSurfaceQuads(LayOutSurface(sheet, cones), options).mesh;
  EXPECT_EQ(mesh.sideNames,
    (std::vector<std::string>{
      "outer0", "outer1", "outer2", "outer3", "hole0", "hole1", "hole2", "hole3" }));
  std::vector<int> edges(8, 0);
  for (std::size_t e = 0; e < mesh.boundary.size(); ++e)
  {
    const QuadBoundaryEdge& edge = mesh.boundary[e];
    ++edges[edge.side];
    const bool isFirst = e == 0 || mesh.boundary[e - 1].side != edge.side;
    EXPECT_EQ(isFirst, mesh.points[edge.points[0]].quarterIndex != 0);
    EXPECT_TRUE(isFirst || mesh.boundary[e - 1].points[1] == edge.points[0]);
  }
  EXPECT_EQ(edges, (std::vector<int>{ 12, 12, 12, 12, 4, 4, 4, 4 }));
}

TEST(SurfaceQuads, RefuseNoSize)
{
  const SurfaceMesh sphere = CubedSphere(4);
  SurfaceQuadOptions options;
  options.quadCount = 0;
  const Layout layout = LayOutSurface(sphere, ConesOfCube(sphere));
  EXPECT_TRUE(Refuses([&] { MakeSurfaceQuads(layout, options); }, { "positive" }));
}
}
}
