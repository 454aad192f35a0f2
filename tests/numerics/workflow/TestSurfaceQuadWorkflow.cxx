#include "Support.h"
#include "SurfaceQuadWorkflow.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
std::vector<SurfaceSingularity> CornersOfCube(double radius, const SpacePoint& centre)
{
  std::vector<SurfaceSingularity> singularities;
  for (int corner = 0; corner < 8; ++corner)
  {
    const SpacePoint direction(corner % 2 * 2 - 1, corner / 2 % 2 * 2 - 1, corner / 4 * 2 - 1);
    singularities.push_back({ centre + radius * direction.normalized(), 1 });
  }
  return singularities;
}

TEST(SurfaceQuadWorkflow, PlacesSingularitiesBetweenVertices)
{
  SurfaceRequest request;
  request.quadCount = 600;
  // Turned, so that they are at no vertices.
  const Eigen::AngleAxisd turn(0.3, SpacePoint(1.0, 2.0, 3.0).normalized());
  for (SurfaceSingularity& one :
    request.singularities.emplace(CornersOfCube(1.0, SpacePoint::Zero())))
  {
    one.place = turn * one.place;
  }
  const QuadWorkflowResult result = MakeQuadsOfSurface(CubedSphere(16), request);
  EXPECT_TRUE(result.events.empty());
  EXPECT_TRUE(result.warnings.empty());
  EXPECT_EQ(result.quads.mesh.EulerCharacteristic(), 2);
  for (const SurfaceSingularity& one : *request.singularities)
  {
    const bool hasNode =
      std::any_of(result.quads.mesh.points.begin(), result.quads.mesh.points.end(),
        [&one](const QuadPoint& point)
        { return point.valence == 3 && (point.place - one.place).norm() < 0.01; });
    EXPECT_TRUE(hasNode);
  }
}

TEST(SurfaceQuadWorkflow, ChoosesSingularities)
{
  SurfaceMesh surface = CubedSphere(12);
  for (SpacePoint& point : surface.points)
  {
    point = point.cwiseProduct(SpacePoint(1.6, 1.0, 0.8));
  }
  SurfaceRequest request;
  request.quadCount = 800;
  const QuadWorkflowResult result = MakeQuadsOfSurface(surface, request);
  EXPECT_EQ(result.quads.mesh.EulerCharacteristic(), 2);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.7);
  const auto irregular = std::count_if(result.quads.mesh.points.begin(),
    result.quads.mesh.points.end(), [](const QuadPoint& point) { return point.valence != 4; });
  EXPECT_EQ(irregular, 8); // of valence 3
  request.coarse = true;
  const QuadWorkflowResult coarse = MakeQuadsOfSurface(surface, request);
  EXPECT_LE(coarse.quads.blocks.blocks.size(), 30u); // 6 at best
  EXPECT_EQ(coarse.quads.blocks.blocks.size(), static_cast<std::size_t>(*coarse.blocks.coarse));
  EXPECT_EQ(*coarse.blocks.none, *result.blocks.none);
  EXPECT_GE(coarse.quads.quality.jacobian.min, 0.5 * result.quads.quality.jacobian.min);
  EXPECT_EQ(coarse.quads.mesh.EulerCharacteristic(), 2);
  request.coarse = false;
  request.singularities.emplace();
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfSurface(surface, request); }, { "add up to 0", "needs" },
    Error::Kind::Inconsistent));
}

TEST(SurfaceQuadWorkflow, MakesGoodQuadsOfSmoothSurfacesAtRandom)
{
  for (unsigned seed = 611; seed < 623; ++seed)
  {
    Random random(seed);
    const bool isTorus = seed % 3 == 0;
    SurfaceMesh surface = isTorus ? Torus(2.5, 60, 24) : CubedSphere(12);
    const double size = isTorus ? 3.5 : 1.0;
    for (int wave = 0; wave < 6; ++wave)
    {
      const SpacePoint along(
        random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0), random.Uniform(-3.0, 3.0));
      const double height = random.Uniform(-0.08, 0.08);
      for (SpacePoint& point : surface.points)
      {
        point *= 1.0 + height * std::sin(along.dot(point) / size + wave);
      }
    }
    SurfaceRequest request;
    request.quadCount = 1500;
    const QuadWorkflowResult result = MakeQuadsOfSurface(surface, request);
    EXPECT_EQ(result.quads.mesh.EulerCharacteristic(), isTorus ? 0 : 2) << seed;
    EXPECT_EQ(result.quads.quality.inverted, 0) << seed;
    EXPECT_GT(result.quads.quality.jacobian.min, 0.5) << seed;
  }
}

TEST(SurfaceQuadWorkflow, DividesCoarseTriangles)
{
  // A cube of twelve triangles: its corners are all neighbours.
  SurfaceMesh cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.points.emplace_back(i % 2, i / 2 % 2, i / 4);
  }
  cube.triangles = { { 0, 3, 1 }, { 0, 2, 3 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 7, 3 }, { 2, 6, 7 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  SurfaceRequest request;
  request.quadCount = 600;
  const QuadWorkflowResult result = MakeQuadsOfSurface(cube, request);
  EXPECT_EQ(result.quads.mesh.quads.size(), 600u);
  EXPECT_EQ(result.quads.blocks.blocks.size(), 6u);
  ASSERT_EQ(result.events.size(), 1u);
  EXPECT_NE(result.events[0].find("divided into 4 each"), std::string::npos);
}

TEST(SurfaceQuadWorkflow, MeshesPartsOneByOne)
{
  SurfaceMesh both = CubedSphere(8);
  const auto count = static_cast<int>(both.points.size());
  for (const SpacePoint& point : CubedSphere(8).points)
  {
    both.points.push_back(2.0 * point + SpacePoint(5.0, 0.0, 0.0));
  }
  for (const auto& v : CubedSphere(8).triangles)
  {
    both.triangles.push_back({ v[0] + count, v[1] + count, v[2] + count });
  }
  SurfaceRequest request;
  request.quadCount = 1000;
  request.singularities = CornersOfCube(1.0, SpacePoint::Zero());
  for (const SurfaceSingularity& one : CornersOfCube(2.0, { 5.0, 0.0, 0.0 }))
  {
    request.singularities->push_back(one);
  }
  const QuadWorkflowResult result = MakeQuadsOfSurface(both, request);
  EXPECT_EQ(result.PartCount(), 2);
  EXPECT_EQ(result.quads.mesh.EulerCharacteristic(), 4);
  EXPECT_EQ(result.quads.mesh.normals.size(), result.quads.mesh.quads.size());
  const auto large = std::count(result.part.begin(), result.part.end(), 0);
  EXPECT_NEAR(static_cast<double>(large), 800.0, 80.0); // 6 n²

  request.singularities->pop_back();
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfSurface(both, request); },
    { "Part 1 of 2", "add up to 7", "needs 8" }, Error::Kind::Inconsistent));
}

TEST(SurfaceQuadWorkflow, RefusesSingularitiesOffTheSurface)
{
  SurfaceRequest request;
  request.singularities = CornersOfCube(1.5, SpacePoint::Zero());
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfSurface(CubedSphere(8), request); },
    { "Singularity 1 at (", "off the surface; move it to the nearest point of it, (" }));
}

TEST(SurfaceQuadWorkflow, GivesSharpCornersIndexOne)
{
  // A bent strip of rhombi with corners of 30 and 150 degrees: two corners have index 1, so 2 is missing.
  SurfaceMesh rhombus;
  constexpr int N = 8;
  for (int i = 0; i <= N; ++i)
  {
    for (int j = 0; j <= N; ++j)
    {
      const double x = (i + std::cos(Pi / 6.0) * j) / N;
      rhombus.points.emplace_back(std::sin(x), 0.5 * j / N, std::cos(x));
      if (i < N && j < N)
      {
        const int a = i * (N + 1) + j;
        rhombus.triangles.push_back({ a, a + N + 1, a + 1 });
        rhombus.triangles.push_back({ a + 1, a + N + 1, a + N + 2 });
      }
    }
  }
  const ConedSurfaces found = PlaceCones(rhombus, {});
  ASSERT_EQ(found.parts.size(), 1u);
  EXPECT_EQ(found.parts[0].cones.size(), 2u);
  EXPECT_EQ(found.parts[0].RequiredQuarters(), 2);
}

TEST(SurfaceQuadWorkflow, ChecksWithoutQuads)
{
  const auto check = [](const SurfaceMesh& surface, int singularities)
  {
    std::vector<SurfaceSingularity> all = CornersOfCube(1.0, SpacePoint::Zero());
    all.resize(static_cast<std::size_t>(singularities));
    return CheckSurface(PlaceCones(surface, all));
  };
  EXPECT_TRUE(check(CubedSphere(6), 8).consistent);
  EXPECT_FALSE(check(CubedSphere(6), 7).consistent);
  EXPECT_NE(check(CubedSphere(6), 7).reason.find("needs 8"), std::string::npos);
  const SurfaceCheck torus = CheckSurface(PlaceCones(Torus(2.5, 30, 12), {}));
  EXPECT_TRUE(torus.consistent);
  EXPECT_EQ(torus.holonomyDefect.size(), 2u);
}
}
}
