#include "Support.h"
#include "SurfaceRefinement.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
struct Measures
{
  double longest = 0.0;
  double smallestAngle = Pi;
  double area = 0.0;
};

Measures MeasuresOf(const SurfaceMesh& surface)
{
  Measures measures;
  for (const auto& v : surface.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const SpacePoint& at = surface.points[static_cast<std::size_t>(v[i])];
      const SpacePoint a = surface.points[static_cast<std::size_t>(v[(i + 1) % 3])] - at;
      const SpacePoint b = surface.points[static_cast<std::size_t>(v[(i + 2) % 3])] - at;
      measures.longest = std::max(measures.longest, a.norm());
      measures.smallestAngle =
        std::min(measures.smallestAngle, std::atan2(a.cross(b).norm(), a.dot(b)));
      measures.area += a.cross(b).norm() / 6.0;
    }
  }
  return measures;
}

TEST(SurfaceRefinement, DividesLongSides)
{
  // A long flat box of six faces of two triangles, as drawings have.
  SurfaceMesh box;
  for (int i = 0; i < 8; ++i)
  {
    box.points.emplace_back(3.0 * (i % 2), i / 2 % 2, 0.2 * (i / 4));
  }
  box.triangles = { { 0, 3, 1 }, { 0, 2, 3 }, { 4, 5, 7 }, { 4, 7, 6 }, { 0, 1, 5 }, { 0, 5, 4 },
    { 2, 7, 3 }, { 2, 6, 7 }, { 0, 4, 6 }, { 0, 6, 2 }, { 1, 3, 7 }, { 1, 7, 5 } };
  const SurfaceMesh refined = Refined(box, 0.1);
  const Measures measures = MeasuresOf(refined);
  EXPECT_LE(measures.longest, 0.1);
  EXPECT_NEAR(measures.area, MeasuresOf(box).area, 1e-12);
  EXPECT_GT(measures.smallestAngle, 10.0 * Pi / 180.0);
  EXPECT_EQ(SurfaceTopology(refined).charts->curvature.size(),
    static_cast<Eigen::Index>(refined.points.size()));
  EXPECT_LT(refined.triangles.size(), 3u * 1767u); // equilateral ones have 0.43 l² each
  for (std::size_t p = 0; p < box.points.size(); ++p)
  {
    EXPECT_EQ(refined.points[p], box.points[p]);
  }
}

TEST(SurfaceRefinement, KeepsCurvedSurfaces)
{
  const SurfaceMesh sphere = CubedSphere(6);
  EXPECT_EQ(Refined(sphere, 10.0).triangles, sphere.triangles);
  const SurfaceMesh refined = Refined(sphere, 0.1);
  EXPECT_LE(MeasuresOf(refined).longest, 0.1);
  EXPECT_NEAR(MeasuresOf(refined).area, MeasuresOf(sphere).area, 1e-10);
  const SurfaceTopology topology(refined);
  EXPECT_EQ(topology.edges.EulerCharacteristic(topology.mesh), 2);
}

TEST(SurfaceRefinement, KeepsRegionsAndLines)
{
  // A square of four triangles; the left one is region 5, and a line leads along the lower side and one diagonal.
  SurfaceMesh square;
  square.points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 }, { 0.0, 1.0, 0.0 },
    { 0.3, 0.4, 0.0 } };
  square.triangles = { { 0, 1, 4 }, { 1, 2, 4 }, { 2, 3, 4 }, { 3, 0, 4 } };
  square.regions = { 0, 0, 0, 5 };
  square.lines = { { 7, -1, -1 }, { -1, 7, -1 }, { -1, -1, -1 }, { -1, -1, -1 } };
  const SurfaceMesh refined = Refined(square, 0.05);
  ASSERT_EQ(refined.regions.size(), refined.triangles.size());
  ASSERT_EQ(refined.lines.size(), refined.triangles.size());
  double area = 0.0;
  double length = 0.0;
  for (std::size_t t = 0; t < refined.triangles.size(); ++t)
  {
    const auto at = [&](std::size_t corner) -> const SpacePoint&
    { return refined.points[static_cast<std::size_t>(refined.triangles[t][corner % 3])]; };
    area += refined.regions[t] == 5 ? 0.5 * (at(1) - at(0)).cross(at(2) - at(0)).norm() : 0.0;
    for (std::size_t i = 0; i < 3; ++i)
    {
      length += refined.lines[t][i] == 7 ? (at(i + 1) - at(i)).norm() : 0.0;
    }
  }
  EXPECT_NEAR(area, 0.5 * 0.3, 1e-12);
  EXPECT_NEAR(length, 1.0 + std::hypot(0.7, 0.6), 1e-12);
}
}
}
