#include "Support.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"
#include "VertexPlacement.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace crossfield::test
{
namespace
{
TEST(VertexPlacement, FindsTheNearestPoint)
{
  Random random(31);
  const SurfaceMesh sphere = CubedSphere(8);
  for (int trial = 0; trial < 50; ++trial)
  {
    const SpacePoint place(
      random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0), random.Uniform(-2.0, 2.0));
    const SurfacePoint nearest = FindNearest(sphere, place);
    EXPECT_NEAR((nearest.place - place).norm(), nearest.distance, 1e-14);
    EXPECT_NEAR(nearest.distance, std::abs(place.norm() - 1.0), 0.02);
    // It is in its triangle, and no vertex is nearer.
    const auto& v = sphere.triangles[nearest.triangle];
    Eigen::Matrix3d corners;
    corners << sphere.points[v[0]], sphere.points[v[1]], sphere.points[v[2]];
    const SpacePoint weights = corners.inverse() * nearest.place;
    EXPECT_NEAR(weights.sum(), 1.0, 1e-12);
    EXPECT_GE(weights.minCoeff(), -1e-12);
    for (const SpacePoint& point : sphere.points)
    {
      EXPECT_GE((point - place).norm(), nearest.distance - 1e-14);
    }
  }
}

TEST(VertexPlacement, MovesAVertexToEachPoint)
{
  Random random(32);
  SurfaceMesh sphere = CubedSphere(8);
  VertexPlacement placement(sphere);
  std::set<int> vertices;
  for (int trial = 0; trial < 20; ++trial)
  {
    const SpacePoint place =
      SpacePoint(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0))
        .normalized();
    const SurfacePoint point = FindNearest(sphere, place);
    const auto placed = placement.Place(point);
    ASSERT_TRUE(placed);
    EXPECT_TRUE(vertices.insert(placed->vertex).second);
    EXPECT_NEAR((sphere.points[placed->vertex] - point.place).norm(), placed->distance, 1e-15);
    EXPECT_EQ(placed->distance, 0.0);
  }
  EXPECT_NO_THROW(SurfaceTopology topology(sphere));
}

TEST(VertexPlacement, LeavesTheBoundaryAndThinTrianglesAlone)
{
  SurfaceMesh square;
  const TriangleMesh grid = GridOfSquare(2);
  square.points = InSpace(grid.points);
  square.triangles = grid.triangles;
  VertexPlacement placement(square);
  // Near a side the only vertex inside would leave thin triangles.
  const auto placed = placement.Place(FindNearest(square, { 0.01, 0.3, 0.0 }));
  ASSERT_TRUE(placed);
  EXPECT_EQ(placed->vertex, 4);
  EXPECT_GT(placed->distance, 0.4);
  EXPECT_EQ(square.points[4], SpacePoint(0.5, 0.5, 0.0));
  EXPECT_FALSE(placement.Place(FindNearest(square, { 0.499, 0.5, 0.0 })));
}

TEST(VertexPlacement, DividesTrianglesBesideSharpEdges)
{
  // The vertices of a box without inner points of its faces are all at edges.
  Random random(33);
  const SurfaceMesh box = BoxWithHoles(1, 1);
  const double area = SurfaceTopology(box).Area();
  int divided = 0;
  for (int trial = 0; trial < 200; ++trial)
  {
    SurfaceMesh surface = box;
    VertexPlacement placement(surface);
    for (int i = 0; i < 4; ++i)
    {
      const int t = random.Integer(0, static_cast<int>(surface.triangles.size()) - 1);
      const auto& v = surface.triangles[static_cast<std::size_t>(t)];
      const double a = random.Uniform(0.0, 1.0);
      const double b = random.Uniform(0.0, 1.0 - a);
      const auto at = [&](std::size_t k) { return surface.points[static_cast<std::size_t>(v[k])]; };
      const SurfacePoint point = { t, (1.0 - a - b) * at(0) + a * at(1) + b * at(2), 0.0 };
      const auto placed = placement.Place(point);
      if (placed && placed->distance == 0.0)
      {
        ++divided;
        EXPECT_EQ(surface.points[static_cast<std::size_t>(placed->vertex)], point.place);
      }
    }
    const SurfaceTopology topology(surface); // a manifold, and the same surface
    EXPECT_NEAR(topology.Area(), area, 1e-12);
    EXPECT_EQ(topology.edges.EulerCharacteristic(topology.mesh), 0);
    for (std::size_t p = 0; p < box.points.size(); ++p)
    {
      EXPECT_EQ(surface.points[p], box.points[p]);
    }
  }
  EXPECT_GT(divided, 400);
}

TEST(VertexPlacement, KeepsVerticesAtTheirPlacesAtSharpEdges)
{
  SurfaceMesh box = BoxWithHoles(1, 2);
  VertexPlacement placement(box);
  const SpacePoint corner = box.points[0];
  const auto placed = placement.Place(FindNearest(box, corner));
  ASSERT_TRUE(placed);
  EXPECT_EQ(placed->distance, 0.0);
  EXPECT_EQ(box.points[static_cast<std::size_t>(placed->vertex)], corner);
}
}
}
