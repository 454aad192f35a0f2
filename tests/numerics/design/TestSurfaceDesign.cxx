#include "SurfaceDesign.h"

#include "Support.h"
#include "SurfaceParts.h"
#include "Surfaces.h"

#include <Eigen/Geometry>

#include <cmath>
#include <string>

namespace crossfield::test
{
namespace
{
/// Returns an ellipsoid of 24 n² triangles.
SurfaceMesh Ellipsoid(int n)
{
  SurfaceMesh surface = CubedSphere(n);
  for (SpacePoint& point : surface.points)
  {
    point = point.cwiseProduct(SpacePoint(1.5, 1.0, 0.8));
  }
  return surface;
}

/// Returns singularities on it where the corners of a turned cube are.
std::vector<SurfaceSingularity> EightOn(double turn)
{
  std::vector<SurfaceSingularity> eight;
  for (int corner = 0; corner < 8; ++corner)
  {
    const SpacePoint direction(corner % 2 * 2 - 1, corner / 2 % 2 * 2 - 1, corner / 4 * 2 - 1);
    const SpacePoint turned = Eigen::AngleAxisd(turn, SpacePoint::UnitZ()) * direction.normalized();
    eight.push_back({ turned.cwiseProduct(SpacePoint(1.5, 1.0, 0.8)), 1 });
  }
  return eight;
}

int SumOf(const std::vector<SurfaceSingularity>& singularities)
{
  int sum = 0;
  for (const SurfaceSingularity& one : singularities)
  {
    sum += one.quarterIndex;
  }
  return sum;
}

TEST(SurfaceDesign, HasPatchesQuadsAndNodes)
{
  const DesignSurface surface(Ellipsoid(16), {}, DefaultFeatureAngle);
  SurfaceQuadOptions quads;
  quads.quadCount = 400;
  const LayoutDesign design = surface.Design(EightOn(0.0), 0.2, quads);
  EXPECT_EQ(design.layouts.Single().tMesh.separatrixCount, 24);
  EXPECT_EQ(design.colours.size(), design.layouts.Single().tMesh.patches.size());
  ASSERT_TRUE(design.quads);
  EXPECT_NEAR(static_cast<double>(design.quads->mesh.quads.size()), 400.0, 60.0);
  ASSERT_EQ(design.onSurface.size(), 8U);
  for (const SurfaceSingularity& one : design.onSurface)
  {
    EXPECT_NEAR(one.place.cwiseQuotient(SpacePoint(1.5, 1.0, 0.8)).norm(), 1.0, 0.02);
  }
  EXPECT_LT(design.nodes.moved, 0.1);
  EXPECT_TRUE(std::isnan(design.energy.energy)) << "W is one of planes";
  EXPECT_NE(design.reason.find("add up to 4χ"), std::string::npos);
  EXPECT_GT(design.shortestArc, 0.0);
}

TEST(SurfaceDesign, ACoarseSurfaceHasNearlyTheSameLayout)
{
  const DesignSurface surface(Ellipsoid(40), {}, DefaultFeatureAngle); // 38,400 triangles
  EXPECT_NEAR(static_cast<double>(surface.Coarse().triangles.size()), 4000.0, 10.0);
  const std::vector<SurfaceSingularity> eight = EightOn(0.3);
  const LayoutDesign coarse = surface.DesignCoarse(eight);
  const LayoutDesign fine = surface.Design(eight, 0.1, std::nullopt);
  EXPECT_FALSE(coarse.quads);
  const auto areaOf = [](const LayoutDesign& design)
  {
    double area = 0.0;
    for (const PatchColour& patch : design.colours)
    {
      area += patch.area;
    }
    return area;
  };
  // Of patches seen along their normals. Their number depends on which separatrices nearly meet.
  EXPECT_NEAR(areaOf(coarse), areaOf(fine), 0.05 * areaOf(fine));
  for (const LayoutDesign* design : { &coarse, &fine })
  {
    const SeamlessMap& map = design->layouts.Single().map;
    EXPECT_EQ(design->layouts.Single().tMesh.separatrixCount, 24);
    ASSERT_EQ(map.cones.size(), 8U);
    for (const Cone& cone : map.cones)
    {
      const SpacePoint& given = eight[static_cast<std::size_t>(cone.row)].place;
      EXPECT_LT((map.topology->PositionOf(cone.vertex) - given).norm(), 0.01);
    }
  }
}

TEST(SurfaceDesign, FollowsSharpEdges)
{
  const DesignSurface can(Can(12), {}, DefaultFeatureAngle);
  const std::vector<SurfaceSingularity> chosen = can.Choose(0.2);
  EXPECT_EQ(SumOf(chosen), 8) << "four on each end";
  for (const SurfaceSingularity& one : chosen)
  {
    EXPECT_NEAR(std::abs(one.place.z()), 1.0, 1e-9);
  }
  SurfaceQuadOptions quads;
  quads.quadCount = 600;
  const LayoutDesign design = can.Design(chosen, 0.2, quads);
  int onEdges = 0;
  for (const QuadBoundaryEdge& edge : design.quads->mesh.boundary)
  {
    onEdges += edge.kind == BoundaryKind::Feature ? 1 : 0;
  }
  EXPECT_GT(onEdges, 20);
  EXPECT_EQ(can.DesignCoarse(chosen).layouts.Single().tMesh.patches.size(),
    design.layouts.Single().tMesh.patches.size());
}

TEST(SurfaceDesign, LargeTrianglesAreDivided)
{
  SurfaceMesh sphere = CubedSphere(2);
  const DesignSurface surface(sphere, {}, Pi);
  EXPECT_GT(surface.Coarse().triangles.size(), 1000U);
  EXPECT_EQ(SumOf(surface.Choose(0.1)), 8);
}

TEST(SurfaceDesign, MovesSingularities)
{
  const DesignSurface surface(Ellipsoid(12), {}, Pi);
  std::vector<SurfaceSingularity> eight = EightOn(0.0);
  eight[0].place = SpacePoint(0.0, 0.0, 0.8); // far from where the others leave room
  const std::vector<SurfaceSingularity> moved = surface.Move(eight);
  ASSERT_EQ(moved.size(), 8U);
  EXPECT_EQ(SumOf(moved), 8);
  EXPECT_GT((moved[0].place - eight[0].place).norm(), 0.1);
}

TEST(SurfaceDesign, RefusesWhatHasNoLayout)
{
  SurfaceMesh two = CubedSphere(4);
  const auto first = static_cast<int>(two.points.size());
  for (const SpacePoint& point : CubedSphere(4).points)
  {
    two.points.emplace_back(point + SpacePoint(5.0, 0.0, 0.0));
  }
  for (const std::array<int, 3>& v : CubedSphere(4).triangles)
  {
    two.triangles.push_back({ first + v[0], first + v[1], first + v[2] });
  }
  EXPECT_TRUE(Refuses([&] { DesignSurface(two, {}, Pi); }, { "2 parts", "Connectivity" }));
  const DesignSurface surface(CubedSphere(8), {}, Pi);
  EXPECT_TRUE(Refuses(
    [&] { surface.DesignCoarse({}); }, { "add up to 0", "needs 8" }, Error::Kind::Inconsistent));
  EXPECT_TRUE(Refuses(
    [&] {
      surface.DesignCoarse({ { { 5.0, 0.0, 0.0 }, 8 } });
    },
    { "off the surface" }));
}
}
}
