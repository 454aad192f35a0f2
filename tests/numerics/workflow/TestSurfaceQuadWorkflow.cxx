#include "Support.h"
#include "SurfaceChoice.h"
#include "SurfaceQuadWorkflow.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>

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

SurfaceMesh CubeOfTwelve()
{
  SurfaceMesh cube;
  for (int i = 0; i < 8; ++i)
  {
    cube.points.emplace_back(i % 2, i / 2 % 2, i / 4);
  }
  cube.triangles = { { 0, 3, 1 }, { 0, 2, 3 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 7, 3 }, { 2, 6, 7 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  return cube;
}

TEST(SurfaceQuadWorkflow, QuadsOfAThinPlateAreOnIt)
{
  SurfaceMesh plate = CubeOfTwelve();
  for (SpacePoint& point : plate.points)
  {
    point = point.cwiseProduct(SpacePoint(2.0, 1.0, 0.1));
  }
  SurfaceRequest request;
  request.quadCount = 300;
  const QuadWorkflowResult result = MakeQuadsOfSurface(plate, request);
  EXPECT_LT(result.quads.quality.surface->maximumDistance, 1e-9) << "all faces are planar";
}

TEST(SurfaceQuadWorkflow, LargeTrianglesOfEachPartAreDivided)
{
  SurfaceMesh cubes = CubeOfTwelve();
  for (const SpacePoint& point : CubeOfTwelve().points)
  {
    cubes.points.emplace_back(0.5 * point + SpacePoint(3.0, 0.0, 0.0));
  }
  for (const std::array<int, 3>& v : CubeOfTwelve().triangles)
  {
    cubes.triangles.push_back({ 8 + v[0], 8 + v[1], 8 + v[2] });
  }
  SurfaceRequest request;
  request.quadCount = 300;
  request.featureAngle = Pi;
  const QuadWorkflowResult result = MakeQuadsOfSurface(cubes, request);
  EXPECT_EQ(result.quads.mesh.EulerCharacteristic(), 4);
  EXPECT_TRUE(AnyHas(result.events, "Part 1: The triangles of the surface were divided"));
  EXPECT_TRUE(AnyHas(result.events, "Part 2: The triangles of the surface were divided"));
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

/// Returns a sphere or, for every third seed, a torus with waves.
SurfaceMesh SmoothSurface(unsigned seed)
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
  return surface;
}

TEST(SurfaceQuadWorkflow, MakesGoodQuadsOfSmoothSurfacesAtRandom)
{
  for (unsigned seed = 611; seed < 623; ++seed)
  {
    const bool isTorus = seed % 3 == 0;
    const SurfaceMesh surface = SmoothSurface(seed);
    SurfaceRequest request;
    request.quadCount = 1500;
    const QuadWorkflowResult result = MakeQuadsOfSurface(surface, request);
    EXPECT_EQ(result.quads.mesh.EulerCharacteristic(), isTorus ? 0 : 2) << seed;
    EXPECT_EQ(result.quads.quality.inverted, 0) << seed;
    EXPECT_GT(result.quads.quality.jacobian.min, 0.5) << seed;
  }
}

TEST(SurfaceQuadWorkflow, MovesSingularitiesWhereThisIsBetter)
{
  int moved = 0;
  for (unsigned seed = 611; seed < 623; ++seed)
  {
    const SurfaceMesh surface = SmoothSurface(seed);
    SurfaceRequest request;
    const QuadWorkflowResult best = MakeQuadsOfSurface(surface, request);
    request.singularities = ChooseSurfaceSingularities(surface, request.featureAngle);
    const QuadWorkflowResult chosen = MakeQuadsOfSurface(surface, request);
    const Range& jacobian = best.quads.quality.jacobian;
    const Range& before = chosen.quads.quality.jacobian;
    const bool isSame = jacobian.min == before.min && jacobian.mean == before.mean;
    EXPECT_EQ(best.events.empty(), isSame) << seed;
    EXPECT_GE(jacobian.min, before.min - 0.01) << seed;
    EXPECT_TRUE(jacobian.min > before.min || jacobian.mean >= before.mean) << seed;
    moved += isSame ? 0 : 1;
  }
  EXPECT_GT(moved, 3);
}

/// Returns a tube along a helix of a turn and a half, open at both ends, of 2 m n triangles.
SurfaceMesh TubeAlongHelix(int m, int n)
{
  SurfaceMesh tube;
  for (int i = 0; i <= n; ++i)
  {
    const double turn = 3.0 * Pi * i / n;
    for (int j = 0; j < m; ++j)
    {
      const double radius = 1.5 + 0.45 * std::cos(2.0 * Pi * j / m);
      tube.points.emplace_back(radius * std::cos(turn), radius * std::sin(turn),
        0.22 * turn + 0.45 * std::sin(2.0 * Pi * j / m));
    }
  }
  for (int i = 0; i < n; ++i)
  {
    for (int j = 0; j < m; ++j)
    {
      const int a = i * m + j;
      const int b = i * m + (j + 1) % m;
      tube.triangles.push_back({ a, a + m, b });
      tube.triangles.push_back({ b, a + m, b + m });
    }
  }
  return tube;
}

TEST(SurfaceQuadWorkflow, LeavesOutPairsThatATubeDoesNotNeed)
{
  const SurfaceMesh tube = TubeAlongHelix(20, 90);
  SurfaceRequest request;
  ASSERT_GT(ChooseSurfaceSingularities(tube, request.featureAngle).size(), 0u)
    << "the test needs a surface on which smooth crosses have pairs";
  const QuadWorkflowResult result = MakeQuadsOfSurface(tube, request);
  for (const QuadPoint& point : result.quads.mesh.points)
  {
    EXPECT_TRUE(point.curve.loop >= 0 || point.valence == 4);
  }
  EXPECT_GT(result.quads.quality.jacobian.min, 0.98);
  EXPECT_LT(result.quads.quality.variation, 0.25);
  ASSERT_FALSE(result.events.empty());
  EXPECT_EQ(result.events.back().rfind("Pairs of opposite singularities were left out", 0), 0u)
    << result.events.back();
}

TEST(SurfaceQuadWorkflow, DividesCoarseTriangles)
{
  // A cube of twelve triangles: its corners are all neighbours.
  const SurfaceMesh cube = CubeOfTwelve();
  SurfaceRequest request;
  request.quadCount = 600;
  const QuadWorkflowResult result = MakeQuadsOfSurface(cube, request);
  EXPECT_EQ(result.quads.mesh.quads.size(), 600u);
  EXPECT_EQ(result.quads.blocks.blocks.size(), 6u);
  ASSERT_EQ(result.events.size(), 2u);
  EXPECT_EQ(result.events[0],
    "Quads follow the lines between faces of the surface: 12 lines between 6 faces.");
  EXPECT_NE(result.events[1].find("until their sides were at most 0.1 long"), std::string::npos);
}

/// Returns the length of the edges of quads on sharp edges, and counts those of which one end is off the lines.
template <typename IsOn>
double LengthOfFeatures(const QuadMesh& mesh, const IsOn& isOn, int& off)
{
  double length = 0.0;
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    if (edge.kind != BoundaryKind::Feature)
    {
      continue;
    }
    const SpacePoint& from = mesh.points[static_cast<std::size_t>(edge.points[0])].place;
    const SpacePoint& to = mesh.points[static_cast<std::size_t>(edge.points[1])].place;
    length += (to - from).norm();
    off += isOn(from) && isOn(to) ? 0 : 1;
  }
  return length;
}

TEST(SurfaceQuadWorkflow, FollowsSharpEdges)
{
  // A box of 3 × 3 × 1 with a hole of 1 × 1: straight lines, so the length is theirs only if all nodes are on them.
  SurfaceRequest request;
  request.quadCount = 900;
  const QuadWorkflowResult result = MakeQuadsOfSurface(BoxWithHoles(1, 4), request);
  const QuadMesh& mesh = result.quads.mesh;
  EXPECT_EQ(mesh.EulerCharacteristic(), 0);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.7);
  int off = 0;
  const auto isOn = [](const SpacePoint& place)
  {
    const SpacePoint rounded = place.array().round().matrix();
    return ((place - rounded).cwiseAbs().array() < 1e-12).count() >= 2;
  };
  EXPECT_NEAR(LengthOfFeatures(mesh, isOn, off), 2 * 12 + 2 * 4 + 8 * 1, 1e-9);
  EXPECT_EQ(off, 0);
  EXPECT_EQ(result.events.front(),
    "Quads follow the lines between faces of the surface: 24 lines between 10 faces.");
  // Blocks end at the lines.
  for (const SpacePoint& normal : mesh.normals)
  {
    EXPECT_NEAR(normal.cwiseAbs().maxCoeff(), 1.0, 1e-9);
  }
}

TEST(SurfaceQuadWorkflow, FollowsCircles)
{
  SurfaceRequest request;
  request.quadCount = 800;
  const QuadWorkflowResult result = MakeQuadsOfSurface(Can(12), request);
  const QuadMesh& mesh = result.quads.mesh;
  EXPECT_EQ(mesh.EulerCharacteristic(), 2);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.7);
  EXPECT_EQ(std::count_if(mesh.points.begin(), mesh.points.end(),
              [](const QuadPoint& point) { return point.valence == 3; }),
    8);
  int off = 0;
  const auto isOn = [](const SpacePoint& place)
  {
    const double radius = place.head<2>().norm();
    return std::abs(std::abs(place.z()) - 1.0) < 1e-12 && radius < 1.0 + 1e-12 && radius > 0.99;
  };
  EXPECT_NEAR(LengthOfFeatures(mesh, isOn, off), 4.0 * Pi, 0.2);
  EXPECT_EQ(off, 0);

  // Without sharp edges quads pass over them.
  request.featureAngle = Pi;
  off = 0;
  EXPECT_EQ(LengthOfFeatures(MakeQuadsOfSurface(Can(12), request).quads.mesh, isOn, off), 0.0);
}

/// Returns a turned part: a closed line of points (r, z), counter-clockwise, turned about the axis z in n steps.
SurfaceMesh Turned(const std::vector<Point>& profile, int n)
{
  SurfaceMesh surface;
  const auto m = static_cast<int>(profile.size());
  for (int k = 0; k < n; ++k)
  {
    const double angle = 2.0 * Pi * k / n;
    for (int i = 0; i < m; ++i)
    {
      const Point& at = profile[static_cast<std::size_t>(i)];
      surface.points.emplace_back(at.x() * std::cos(angle), at.x() * std::sin(angle), at.y());
      const int a = k * m + i;
      const int b = k * m + (i + 1) % m;
      const int shift = k + 1 < n ? m : (1 - n) * m;
      surface.triangles.push_back({ a, a + shift, b });
      surface.triangles.push_back({ b, a + shift, b + shift });
    }
  }
  return surface;
}

TEST(SurfaceQuadWorkflow, LeavesOutPairsIfNumbersOfEdgesContradict)
{
  // The ends are rings, which have pairs of singularities by themselves, but the walls demand equal numbers of
  // edges on all circles.
  const SurfaceMesh part = Turned(
    { { 0.2, 0.0 }, { 1.2, 0.0 }, { 1.2, 0.5 }, { 0.8, 0.5 }, { 0.8, 1.0 }, { 0.2, 1.0 } }, 24);
  SurfaceRequest request;
  request.quadCount = 800;
  const QuadWorkflowResult result = MakeQuadsOfSurface(part, request);
  EXPECT_EQ(result.quads.mesh.EulerCharacteristic(), 0);
  EXPECT_EQ(result.quads.quality.inverted, 0);
  EXPECT_EQ(result.quads.blocks.blocks.size(), 6u);
  const auto told = std::count_if(result.events.begin(), result.events.end(),
    [](const std::string& event) { return event.find("left out in pairs") != std::string::npos; });
  EXPECT_EQ(told, 1);

  // Given ones are kept, so there is no mesh: eight of a ring, none elsewhere.
  request.singularities.emplace();
  for (int i = 0; i < 8; ++i)
  {
    const double angle = Pi * (i + 0.5) / 4.0;
    const double radius = i % 2 == 0 ? 0.5 : 0.9;
    request.singularities->push_back(
      { SpacePoint(radius * std::cos(angle), radius * std::sin(angle), 0.0), i % 2 == 0 ? -1 : 1 });
  }
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfSurface(part, request); },
    { "No numbers of edges fit the faces", "one with the line between faces at (", "FeatureAngle" },
    Error::Kind::Inconsistent));
}

TEST(SurfaceQuadWorkflow, LeavesSingularitiesOnSharpEdgesToTheirAngles)
{
  SurfaceRequest request;
  request.quadCount = 600;
  request.singularities.emplace();
  for (int corner = 0; corner < 8; ++corner)
  {
    request.singularities->push_back({ SpacePoint(corner % 2, corner / 2 % 2, corner / 4), 1 });
  }
  const QuadWorkflowResult result = MakeQuadsOfSurface(CubeOfTwelve(), request);
  EXPECT_EQ(result.quads.mesh.quads.size(), 600u);
  const auto told = std::count_if(result.events.begin(), result.events.end(),
    [](const std::string& event)
    { return event.find("is on a line between faces") != std::string::npos; });
  EXPECT_EQ(told, 8);
  // One on a face needs others there.
  request.singularities = { { SpacePoint(0.5, 0.5, 1.0), 1 } };
  EXPECT_TRUE(Refuses([&] { MakeQuadsOfSurface(CubeOfTwelve(), request); },
    { "Face at (0.", "add up to 1", "needs" }, Error::Kind::Inconsistent));
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
  ASSERT_EQ(found.bodies.size(), 1u);
  ASSERT_EQ(found.bodies[0].faces.size(), 1u);
  EXPECT_EQ(found.bodies[0].faces[0].cones.size(), 2u);
  EXPECT_EQ(found.bodies[0].faces[0].RequiredQuarters(), 2);
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

TEST(SurfaceQuadWorkflow, FollowsRegionsAndNamedLines)
{
  // A hemisphere whose cap is a region of its own, with half of its boundary and a part of the circle around the cap
  // named.
  SurfaceMesh half = Hemisphere(16);
  SurfaceRequest request;
  request.quadCount = 800;
  request.names = { { "shell", "cap" }, { "rim", "weld" } };
  const auto isCap = [&](const std::array<int, 3>& v)
  {
    SpacePoint centre = SpacePoint::Zero();
    for (const int vertex : v)
    {
      centre += half.points[static_cast<std::size_t>(vertex)] / 3.0;
    }
    return centre.z() > std::max(std::abs(centre.x()), std::abs(centre.y()));
  };
  for (const auto& v : half.triangles)
  {
    half.regions.push_back(isCap(v) ? 1 : 0);
    std::array<int, 3> lines{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const SpacePoint& a = half.points[static_cast<std::size_t>(v[i])];
      const SpacePoint& b = half.points[static_cast<std::size_t>(v[(i + 1) % 3])];
      const auto isWeld = [](const SpacePoint& point)
      { return std::abs(point.z() - point.x()) < 1e-9; };
      const bool isRim = std::abs(a.z()) + std::abs(b.z()) < 1e-12 && a.x() + b.x() > 0.0;
      lines[i] = isRim ? 0 : isCap(v) && isWeld(a) && isWeld(b) ? 1 : -1;
    }
    half.lines.push_back(lines);
  }
  const QuadWorkflowResult result = MakeQuadsOfSurface(half, request);
  EXPECT_TRUE(result.warnings.empty());
  const QuadMesh& mesh = result.quads.mesh;
  EXPECT_EQ(mesh.EulerCharacteristic(), 1);
  EXPECT_GT(result.quads.quality.jacobian.min, 0.5);
  EXPECT_EQ(result.materials, request.names.regions);
  ASSERT_EQ(result.regions.size(), 2u);
  ASSERT_EQ(result.region.size(), mesh.quads.size());
  EXPECT_EQ(result.regions[0].quads + result.regions[1].quads, mesh.quads.size());
  for (std::size_t q = 0; q < mesh.quads.size(); ++q)
  {
    SpacePoint centre = SpacePoint::Zero();
    for (const int point : mesh.quads[q])
    {
      centre += 0.25 * mesh.points[static_cast<std::size_t>(point)].place;
    }
    const RegionReport& region = result.regions[static_cast<std::size_t>(result.region[q])];
    EXPECT_EQ(
      region.material, centre.z() > std::max(std::abs(centre.x()), std::abs(centre.y())) ? 1 : 0);
  }
  std::map<std::string, double> lengths;
  for (const QuadBoundaryEdge& edge : mesh.boundary)
  {
    const std::string& name = mesh.sideNames[static_cast<std::size_t>(edge.side)];
    lengths[name] += (mesh.points[static_cast<std::size_t>(edge.points[0])].place -
      mesh.points[static_cast<std::size_t>(edge.points[1])].place)
                       .norm();
    const bool isInside = name == "weld" || name == "shell+cap";
    EXPECT_EQ(edge.kind, isInside ? BoundaryKind::Interface : BoundaryKind::Outer) << name;
  }
  ASSERT_EQ(lengths.size(), 4u);
  EXPECT_NEAR(lengths["rim"], Pi, 0.01);
  EXPECT_NEAR(lengths["outer0"], Pi, 0.01);
  const double side = 2.0 * std::asin(std::sqrt(1.0 / 3.0)); // of the cube, blown up
  EXPECT_NEAR(lengths["weld"], side, 0.01);
  EXPECT_NEAR(lengths["shell+cap"], 3.0 * side, 0.03);
  EXPECT_EQ(result.interfaces.size(), 2u);

  // The line between the regions has two names.
  const auto edgesBetween = [](const QuadMesh& made)
  {
    return std::count_if(made.boundary.begin(), made.boundary.end(),
      [&made](const QuadBoundaryEdge& edge)
      { return made.sideNames[static_cast<std::size_t>(edge.side)] == "shell+cap"; });
  };
  const auto count = static_cast<int>(edgesBetween(mesh));
  request.sides = { { "cap+shell", count, 0.0 } };
  EXPECT_EQ(edgesBetween(MakeQuadsOfSurface(half, request).quads.mesh), count);
}
}
}
