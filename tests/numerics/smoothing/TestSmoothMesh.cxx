#include "SmoothMesh.h"

#include "Support.h"
#include "Surfaces.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// A grid of n × n quads on [0, 1]², whose points are moved at random by up to a part of the size of
/// quads: inside, and along the sides.
PlainQuads Grid(int n, double part, Random& random)
{
  PlainQuads mesh;
  const auto at = [n](int i, int j) { return j * (n + 1) + i; };
  for (int j = 0; j <= n; ++j)
  {
    for (int i = 0; i <= n; ++i)
    {
      const double x = i % n == 0 ? 0.0 : random.Uniform(-part, part);
      const double y = j % n == 0 ? 0.0 : random.Uniform(-part, part);
      mesh.points.emplace_back((i + x) / n, (j + y) / n, 0.0);
    }
  }
  for (int j = 0; j < n; ++j)
  {
    for (int i = 0; i < n; ++i)
    {
      mesh.quads.push_back({ at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1) });
    }
  }
  return mesh;
}

/// Quads of the triangles of a disk, three of each: as other programs divide triangles.
PlainQuads DividedTriangles(double meshSize)
{
  const TriangleMesh triangles = DrillMesh(Builtin("disk"), {}, meshSize);
  const EdgeNumbering edges = NumberEdges(triangles);
  PlainQuads mesh;
  mesh.points = InSpace(triangles.points);
  for (const auto& [from, to] : edges.vertices)
  {
    mesh.points.push_back(InSpace(0.5 * (triangles.points[from] + triangles.points[to])));
  }
  for (std::size_t t = 0; t < triangles.triangles.size(); ++t)
  {
    const auto& v = triangles.triangles[t];
    const int centre = static_cast<int>(mesh.points.size());
    mesh.points.push_back(
      InSpace((triangles.points[v[0]] + triangles.points[v[1]] + triangles.points[v[2]]) / 3.0));
    const auto middle = [&](int i)
    { return static_cast<int>(triangles.points.size()) + edges.ofTriangle[t][i % 3]; };
    for (int i = 0; i < 3; ++i)
    {
      mesh.quads.push_back({ v[i], middle(i), centre, middle(i + 2) });
    }
  }
  return mesh;
}

double LargestDistance(const std::vector<SpacePoint>& a, const std::vector<SpacePoint>& b)
{
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
  {
    largest = std::max(largest, (a[i] - b[i]).norm());
  }
  return largest;
}

TEST(SmoothMesh, EqualSquaresAreTheMinimumOfEqualSizes)
{
  // The energy of the regular grid is the smallest possible, and only that grid has it.
  Random random(1101);
  Random none(1);
  MeshSmoothingOptions options;
  options.uniform = true;
  for (const int n : { 8, 80 }) // alone, and with coarser meshes
  {
    const PlainQuads mesh = Grid(n, 0.4, random);
    const SmoothedMesh smoothed = SmoothMesh(mesh, options);
    // With coarser meshes, the descent ends at a hundredth of the energy above the ideal one.
    EXPECT_LE(LargestDistance(smoothed.points, Grid(n, 0.0, none).points), 0.05 / n) << n;
    EXPECT_LT(smoothed.before.jacobian.min, 0.8);
    EXPECT_GT(smoothed.after.jacobian.min, 0.99);
  }
}

TEST(SmoothMesh, BoundaryStaysIfItShould)
{
  Random random(1102);
  const PlainQuads mesh = Grid(10, 0.4, random);
  MeshSmoothingOptions options;
  options.slides = false;
  const SmoothedMesh smoothed = SmoothMesh(mesh, options);
  int moved = 0;
  for (std::size_t p = 0; p < mesh.points.size(); ++p)
  {
    const SpacePoint& place = mesh.points[p];
    const bool onBoundary = place.x() * (1.0 - place.x()) * place.y() * (1.0 - place.y()) < 1e-12;
    moved += smoothed.points[p] != place ? 1 : 0;
    EXPECT_TRUE(!onBoundary || smoothed.points[p] == place);
  }
  EXPECT_GT(moved, 60);
  EXPECT_GT(smoothed.after.jacobian.min, smoothed.before.jacobian.min);
}

TEST(SmoothMesh, RepairsInvertedQuads)
{
  Random random(1103);
  for (int trial = 0; trial < 20; ++trial)
  {
    PlainQuads mesh = Grid(8, 0.2, random);
    for (int k = 0; k < 3; ++k)
    {
      // far beyond its neighbours
      const int p = random.Integer(1, 7) * 9 + random.Integer(1, 7);
      mesh.points[p] += SpacePoint(random.Uniform(-0.4, 0.4), random.Uniform(-0.4, 0.4), 0.0);
    }
    const SmoothedMesh smoothed = SmoothMesh(mesh, {});
    EXPECT_GT(smoothed.before.inverted, 0);
    EXPECT_EQ(smoothed.after.inverted, 0);
    EXPECT_GT(smoothed.after.jacobian.min, 0.5);
  }
}

TEST(SmoothMesh, RepairsQuadsOfNearlyNoArea)
{
  constexpr int N = 8;
  Random none(1);
  const PlainQuads grid = Grid(N, 0.0, none);
  MeshSmoothingOptions options;
  options.uniform = true;
  for (const double height : { 1e-13, 1e-10, 1e-7, 1e-5, 1e-4 })
  {
    // A corner of an inner quad, moved nearly to the diagonal between its neighbours.
    PlainQuads mesh = grid;
    SpacePoint& corner = mesh.points[4 * (N + 1) + 4];
    corner += (0.5 - height) / N * SpacePoint(1.0, 1.0, 0.0);
    EXPECT_GT(SmoothMesh(mesh, options).after.jacobian.min, 0.99) << height;
  }
}

TEST(SmoothMesh, ImprovesUnstructuredMeshes)
{
  for (const double meshSize :
    { 0.2, 0.03 }) // below and above the number that coarser meshes are for
  {
    const PlainQuads mesh = DividedTriangles(meshSize);
    const SmoothedMesh smoothed = SmoothMesh(mesh, {});
    EXPECT_EQ(smoothed.after.inverted, 0);
    EXPECT_GT(smoothed.after.jacobian.min, smoothed.before.jacobian.min);
    EXPECT_GT(smoothed.after.jacobian.mean, smoothed.before.jacobian.mean + 0.01);
    for (const SpacePoint& place : smoothed.points)
    {
      EXPECT_LT(place.norm(), 1.0 + 1e-12); // sliding leads along chords
    }
  }
}

TEST(SmoothMesh, OrientationAndOrderOfCornersDoNotMatter)
{
  Random random(1104);
  const PlainQuads mesh = Grid(9, 0.3, random);
  PlainQuads other = mesh;
  for (auto& quad : other.quads)
  {
    std::rotate(quad.begin(), quad.begin() + random.Integer(0, 3), quad.end());
    if (random.Integer(0, 1) == 1)
    {
      std::reverse(quad.begin(), quad.end());
    }
  }
  EXPECT_LE(LargestDistance(SmoothMesh(mesh, {}).points, SmoothMesh(other, {}).points), 1e-4);
}

TEST(SmoothMesh, RefusesWhatIsNoMesh)
{
  using Points = std::vector<Point>;
  Random random(1105);
  const PlainQuads grid = Grid(2, 0.0, random);
  const auto refuses = [](const PlainQuads& mesh, const std::string& words)
  { return Refuses([&] { SmoothMesh(mesh, {}); }, { words }); };
  EXPECT_TRUE(refuses({ grid.points, {} }, "The mesh has no quads"));
  PlainQuads mesh = grid;
  mesh.quads[0][1] = mesh.quads[0][0];
  EXPECT_TRUE(refuses(mesh, "has a point twice"));
  mesh = grid;
  mesh.quads.push_back({ 0, 1, 4, 6 });
  EXPECT_TRUE(refuses(mesh, "has more than two quads"));
  mesh = { InSpace(Points{ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { 2, 1 }, { 2, 2 }, { 1, 2 } }),
    { { 0, 1, 2, 3 }, { 2, 4, 5, 6 } } };
  EXPECT_TRUE(refuses(mesh, "The boundary touches itself near (1, 1)"));
  mesh = { InSpace(Points{ { 0, 0 }, { 0, 0 }, { 0, 0 }, { 0, 0 } }), { { 0, 1, 2, 3 } } };
  EXPECT_TRUE(refuses(mesh, "have no area"));
  // A Möbius strip of three quads.
  mesh = { InSpace(Points{ { 0, 0 }, { 0, 1 }, { 1, 0 }, { 1, 1 }, { 2, 0 }, { 2, 2 } }),
    { { 0, 2, 3, 1 }, { 2, 4, 5, 3 }, { 4, 1, 0, 5 } } };
  EXPECT_TRUE(refuses(mesh, "cannot be oriented"));
}

TEST(SmoothMesh, IsThatOfThePlaneOnATurnedOne)
{
  Random random(1106);
  const TriangleMesh square = GridOfSquare(7);
  const SurfaceMesh surface = BentAtRandom(square, 7, 0, 0.0);
  for (const int n : { 9, 80 }) // alone, and with coarser meshes
  {
    for (const bool isUniform : { false, true })
    {
      const PlainQuads mesh = Grid(n, 0.2, random);
      PlainQuads turned = mesh;
      for (SpacePoint& point : turned.points)
      {
        point = TurnOfBent() * point;
      }
      MeshSmoothingOptions options;
      options.uniform = isUniform;
      const SmoothedMesh inPlane = SmoothMesh(mesh, options);
      SmoothedMesh onSurface = SmoothMesh(turned, options, {}, &surface);
      for (SpacePoint& point : onSurface.points)
      {
        point = TurnOfBent().transpose() * point;
      }
      EXPECT_LT(LargestDistance(inPlane.points, onSurface.points), 1e-8) << n << isUniform;
      EXPECT_NEAR(inPlane.after.jacobian.min, onSurface.after.jacobian.min, 1e-8);
    }
  }
}

TEST(SmoothMesh, StaysOnASurface)
{
  const auto height = [](const SpacePoint& place)
  { return 0.15 * std::sin(4.0 * place.x()) * std::cos(3.0 * place.y()); };
  const TriangleMesh square = GridOfSquare(60);
  SurfaceMesh surface;
  surface.points = InSpace(square.points);
  surface.triangles = square.triangles;
  for (SpacePoint& point : surface.points)
  {
    point.z() = height(point);
  }
  Random random(1107);
  PlainQuads mesh = Grid(16, 0.35, random);
  for (SpacePoint& point : mesh.points)
  {
    point.z() = height(point) + random.Uniform(-0.01, 0.01); // beside the surface
  }
  for (const bool slides : { true, false })
  {
    MeshSmoothingOptions options;
    options.slides = slides;
    const SmoothedMesh smoothed = SmoothMesh(mesh, options, {}, &surface);
    EXPECT_LT(smoothed.before.jacobian.min, 0.6);
    EXPECT_GT(smoothed.after.jacobian.min, slides ? 0.85 : 0.7);
    for (std::size_t p = 0; p < mesh.points.size(); ++p)
    {
      const SpacePoint& place = smoothed.points[p];
      EXPECT_NEAR(place.z(), height(place), 1e-3); // of triangles with sides of 1/60
      for (const int axis : { 0, 1 })
      {
        const double given = mesh.points[p][axis];
        // Corners given beside the surface go to the nearest place of its boundary.
        const double other = mesh.points[p][1 - axis];
        const double near = other * (1.0 - other) == 0.0 ? 0.02 : 1e-12;
        EXPECT_TRUE(given * (1.0 - given) != 0.0 || std::abs(place[axis] - given) < near);
      }
    }
  }
  SurfaceMesh two = surface;
  for (const SpacePoint& point : surface.points)
  {
    two.points.push_back(point + SpacePoint(3.0, 0.0, 0.0));
  }
  for (auto triangle : surface.triangles)
  {
    for (int& vertex : triangle)
    {
      vertex += static_cast<int>(surface.points.size());
    }
    two.triangles.push_back(triangle);
  }
  EXPECT_TRUE(Refuses([&] { SmoothMesh(mesh, {}, {}, &two); }, { "2 parts", "Connectivity" }));
  const SurfaceMesh none;
  EXPECT_TRUE(Refuses([&] { SmoothMesh(mesh, {}, {}, &none); }, { "no triangle with an area" }));
}
}
}
