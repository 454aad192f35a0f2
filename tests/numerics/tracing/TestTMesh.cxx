#include "TMeshChecks.h"

#include "BuiltinDomains.h"
#include "MakePlanarDomain.h"
#include "MeshForPoints.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
struct Case
{
  std::string name;
  PlanarDomain domain;
  Configuration configuration;
  int faces;
  int arcs;
};

std::vector<Case> ReferenceCases()
{
  return {
    { "five around one", DiskOfEdges(0.04),
      Join(OnCircle(5, 0.7, 0.1, 1, 0.0), { { { 0.0, 0.0 }, -1 } }), 15, 40 },
    { "six around two", DiskOfEdges(0.04),
      Join(OnCircle(6, 0.7, 0.1, 1, 0.0), { { { 0.2, 0.0 }, -1 }, { { -0.2, 0.0 }, -1 } }), 21,
      56 },
    { "L-shape with a pair", LShape(), { { { 0.45, 0.55 }, 1 }, { { 1.3, 0.5 }, -1 } }, 9, 26 },
    { "ring with eight", RingOfEdges(0.04),
      Join(OnCircle(4, 0.8, 0.1, 1, 0.0), OnCircle(4, 0.55, 0.1, -1, 0.0)), 24, 64 },
    { "hexagon", Builtin("hexagonal"), { { { 0.469, 0.0 }, -1 }, { { -0.469, 0.0 }, -1 } }, 8, 23 },
    { "L-shape", LShape(), {}, 3, 10 },
    { "ring", RingOfEdges(0.04), {}, 1, 3 },
  };
}

TEST(TMesh, HasTheCountsOfReferenceCases)
{
  for (const Case& reference : ReferenceCases())
  {
    SCOPED_TRACE(reference.name);
    const TMesh mesh = LinesOf(reference.domain, reference.configuration, 0.04);
    EXPECT_EQ(Count(mesh.patches.size()), reference.faces);
    EXPECT_EQ(Count(mesh.arcs.size()), reference.arcs);
    ExpectSound(mesh, reference.domain.EulerCharacteristic());
  }
}

/// The paper's domains and one of its configurations, with singularities at the minimum of W,
/// rounded so that none is exactly symmetric.
TEST(TMesh, HasTheCountsOfThePapersDomains)
{
  BuiltinDomain ellipse;
  ellipse.name = "ellipse";
  ellipse.width = 6.0;
  ellipse.height = 1.2;
  const std::vector<Case> cases = {
    { "ellipse", MakePlanarDomain(MakeBuiltinDomain(ellipse)),
      { { { -2.1, -0.2 }, 1 }, { { -2.11, 0.21 }, 1 }, { { 2.12, -0.2 }, 1 },
        { { 2.1, 0.19 }, 1 } },
      9, 24 },
    { "quarter-disk", Builtin("quarter-disk"), { { { 0.601, 0.602 }, 1 } }, 3, 9 },
    { "angular-balanced", Builtin("angular-balanced"), {}, 1, 4 },
    { "angular-negative", Builtin("angular-negative"),
      { { { -0.19, -0.335 }, -1 }, { { 0.195, 0.33 }, -1 } }, 9, 26 },
    { "angular-positive", Builtin("angular-positive"),
      { { { -0.19, 0.235 }, 1 }, { { 0.185, -0.24 }, 1 } }, 5, 14 },
    { "angular-hole", Builtin("angular-hole"), { { { -0.111, 0.0 }, -1 }, { { 0.111, 0.0 }, -1 } },
      6, 16 },
    { "h_field", Builtin("l-shape"),
      { { { 0.15, 0.2 }, 1 }, { { 0.9, 0.15 }, 1 }, { { 0.7, 0.38 }, 1 }, { { 0.2, 0.8 }, 1 },
        { { 0.55, 0.15 }, -1 }, { { 0.2, 0.55 }, -1 }, { { 0.4, 0.36 }, -1 },
        { { 0.85, 0.5 }, -1 } },
      25, 69 }, // the last singularity is on the boundary
  };
  for (const Case& paper : cases)
  {
    SCOPED_TRACE(paper.name);
    const TMesh mesh = LinesOf(paper.domain, paper.configuration, 0.05);
    EXPECT_EQ(Count(mesh.patches.size()), paper.faces);
    EXPECT_EQ(Count(mesh.arcs.size()), paper.arcs);
    ExpectSound(mesh, paper.domain.EulerCharacteristic());
  }
}

TEST(TMesh, LShapeIsThreeUnitSquares)
{
  const TMesh mesh = LinesOf(LShape(), {}, 0.1);
  for (const TPatch& face : mesh.patches)
  {
    EXPECT_NEAR(mesh.SideLength(face, 0), 1.0, 1e-10);
    EXPECT_NEAR(mesh.SideLength(face, 1), 1.0, 1e-10);
  }
}

TEST(TMesh, RingHasSidesInTheRatioOfLogarithms)
{
  const TMesh mesh = LinesOf(RingOfEdges(0.02), {}, 0.02);
  ASSERT_EQ(mesh.patches.size(), 1U);
  EXPECT_EQ(mesh.extraSeparatrices, 1);
  const double a = mesh.SideLength(mesh.patches[0], 0);
  const double b = mesh.SideLength(mesh.patches[0], 1);
  EXPECT_NEAR(std::max(a, b) / std::min(a, b), 2.0 * Pi / std::log(2.5), 2e-3);
}

/// Compares with the exact T-mesh of docs/method.md §13.4: a square s × s and four strips s × t.
TEST(TMesh, ConvergesAtSecondOrderOnTheDisk)
{
  for (const auto& [radius, s, t] : { std::array<double, 3>{ 0.85, 1.358896, 0.238244 },
         std::array<double, 3>{ 0.6, 1.094482, 0.443977 } })
  {
    std::vector<double> sizes;
    std::vector<double> errors;
    for (const double size : { 0.2, 0.1, 0.05, 0.025 })
    {
      const TMesh mesh = LinesOf(DiskOfEdges(size), OnCircle(4, radius, Pi / 4.0, 1, 0.0), size);
      ExpectSound(mesh, 1);
      std::vector<double> widths;
      for (const TPatch& face : mesh.patches)
      {
        widths.push_back(std::min(mesh.SideLength(face, 0), mesh.SideLength(face, 1)));
      }
      std::sort(widths.rbegin(), widths.rend());
      sizes.push_back(size);
      errors.push_back(std::abs(widths[0] - s) + std::abs(widths[1] - t));
    }
    EXPECT_GT(ConvergenceRate(sizes, errors), 1.8);
    EXPECT_LT(errors.back(), 4e-4);
  }
}

/// Joins a mesh with its mirror image across x = 0 (y = 0).
TriangleMesh JoinMirrored(const TriangleMesh& half, Eigen::Index axis)
{
  TriangleMesh mesh = half;
  const auto onAxis = [&half, axis](int v)
  { return std::abs(half.points[static_cast<std::size_t>(v)][axis]) < 1e-12; };
  std::vector<int> image;
  for (int v = 0; v < Count(half.points.size()); ++v)
  {
    Point& point = mesh.points[static_cast<std::size_t>(v)];
    if (onAxis(v))
    {
      point[axis] = 0.0;
      image.push_back(v);
      continue;
    }
    image.push_back(Count(mesh.points.size()));
    Point mirrored = point;
    mirrored[axis] = -mirrored[axis];
    mesh.points.push_back(mirrored);
  }
  const auto at = [&image](int v) { return image[static_cast<std::size_t>(v)]; };
  for (const auto& v : half.triangles)
  {
    mesh.triangles.push_back({ at(v[0]), at(v[2]), at(v[1]) });
  }
  mesh.boundary.clear();
  for (BoundaryEdge edge : half.boundary)
  {
    if (!onAxis(edge.vertices[0]) || !onAxis(edge.vertices[1]))
    {
      mesh.boundary.push_back(edge);
      edge.vertices = { at(edge.vertices[1]), at(edge.vertices[0]) };
      mesh.boundary.push_back(edge);
    }
  }
  return mesh;
}

TEST(TMesh, SeparatricesMeetHeadOnOnAnExactlySymmetricMesh)
{
  Loop quarter;
  for (int i = 0; i <= 20; ++i)
  {
    const double angle = 0.5 * Pi * i / 20.0;
    quarter.emplace_back(std::cos(angle), std::sin(angle));
  }
  quarter.front().y() = quarter.back().x() = 0.0;
  quarter.emplace_back(0.0, 0.0);
  const Configuration one = OnCircle(1, 0.6, 0.7, 1, 0.0);
  const TriangleMesh mesh =
    JoinMirrored(JoinMirrored(MeshThroughPoints(MakePlanarDomain({ quarter }), one, 0.08), 0), 1);
  Configuration four;
  for (const double x : { -1.0, 1.0 })
  {
    for (const double y : { -1.0, 1.0 })
    {
      four.push_back({ { x * one[0].position.x(), y * one[0].position.y() }, 1 });
    }
  }
  const TMesh symmetric = LinesOn(mesh, four);
  EXPECT_EQ(symmetric.headOn, 4);
  EXPECT_EQ(symmetric.patches.size(), 5U);
  EXPECT_EQ(symmetric.arcs.size(), 12U);
  ExpectSound(symmetric, 1);

  Random random(31);
  for (int i = 0; i < 5; ++i)
  {
    TriangleMesh moved = mesh;
    for (Point& point : moved.points)
    {
      point += 1e-9 * Point(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
    }
    ExpectSound(LinesOn(moved, four), 1);
  }
}

/// Returns a domain with two reflex corners that face each other, and with a third separatrix
/// through the middle between them.
PlanarDomain Junction(double depth, const std::array<double, 3>& shift)
{
  return MakePlanarDomain(
    { { { -2.0, shift[0] }, { -0.5, shift[0] }, { -0.5, -2.0 }, { 0.5, -2.0 }, { 0.5, shift[1] },
      { 2.0, shift[1] }, { 2.0, depth }, { shift[2], depth }, { shift[2], 1.5 }, { -2.0, 1.5 } } });
}

TEST(TMesh, SeparatricesOfFacingCornersMeetHeadOn)
{
  const TMesh early = LinesOf(Junction(0.3, { 0.0, 0.0, 0.0 }), {}, 0.15);
  EXPECT_EQ(early.headOn, 0); // the third separatrix arrives first
  ExpectSound(early, 1);
  const TMesh late = LinesOf(Junction(0.8, { 0.0, 0.0, 0.0 }), {}, 0.15);
  EXPECT_EQ(late.headOn, 1);
  ExpectSound(late, 1);
  Random random(32);
  for (const double size : { 0.0, 1e-15, 1e-13, 1e-12, 1e-11, 1e-10, 1e-9, 1e-6 })
  {
    for (int i = 0; i < 5; ++i)
    {
      SCOPED_TRACE(size);
      const auto small = [&] { return size * random.Uniform(-1.0, 1.0); };
      const double depth = 0.5 + small();
      ExpectSound(LinesOf(Junction(depth, { small(), small(), small() }), {}, 0.15), 1);
    }
  }
}
}
}
