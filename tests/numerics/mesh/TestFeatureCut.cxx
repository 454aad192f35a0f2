#include "FeatureCut.h"
#include "Support.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

namespace crossfield::test
{
namespace
{
CutSurface CutOf(const SurfaceMesh& surface)
{
  return CutAlongFeatures(surface, FindFeatureEdges(surface, DefaultFeatureAngle));
}

/// Both sides of a line are at the same places, and its points are on the boundaries of the faces.
void ExpectLinesOf(const CutSurface& cut)
{
  for (const FeatureLine& line : cut.lines)
  {
    ASSERT_EQ(line.points[0].size(), line.points[1].size());
    for (std::size_t i = 0; i < line.points[0].size(); ++i)
    {
      const auto placeOf = [&](std::size_t side)
      {
        return cut.faces[static_cast<std::size_t>(line.faces[side])]
          .points[static_cast<std::size_t>(line.points[side][i])];
      };
      EXPECT_EQ(placeOf(0), placeOf(1));
    }
  }
}

TEST(FeatureCut, DividesABoxIntoItsFaces)
{
  for (const int genus : { 0, 1, 2 })
  {
    const SurfaceMesh box = BoxWithHoles(genus, 3);
    const FeatureEdges features = FindFeatureEdges(box, DefaultFeatureAngle);
    EXPECT_TRUE(features.events.empty());
    const CutSurface cut = CutAlongFeatures(box, features);
    EXPECT_EQ(cut.faces.size(), static_cast<std::size_t>(6 + 4 * genus));
    EXPECT_EQ(cut.lines.size(), static_cast<std::size_t>(12 + 12 * genus));
    EXPECT_EQ(cut.nodes.size(), static_cast<std::size_t>(8 + 8 * genus));
    for (const FeatureNode& node : cut.nodes)
    {
      EXPECT_EQ(node.corners.size(), 3u);
      EXPECT_FALSE(node.isOnBoundary);
    }
    ExpectLinesOf(cut);
    std::size_t triangles = 0;
    for (const SurfaceMesh& face : cut.faces)
    {
      const SurfaceTopology topology(face);
      triangles += face.triangles.size();
      // The top and the bottom have the holes.
      const auto holes = static_cast<int>(topology.loops.size()) - 1;
      EXPECT_TRUE(holes == 0 || holes == genus);
    }
    EXPECT_EQ(triangles, box.triangles.size());
  }
}

TEST(FeatureCut, HasClosedLines)
{
  const CutSurface cut = CutOf(Can(8));
  EXPECT_EQ(cut.faces.size(), 3u);
  EXPECT_TRUE(cut.nodes.empty());
  ASSERT_EQ(cut.lines.size(), 2u);
  for (const FeatureLine& line : cut.lines)
  {
    EXPECT_TRUE(line.isClosed);
    EXPECT_EQ(line.points[0].size(), 4u * 8u);
  }
  ExpectLinesOf(cut);
}

TEST(FeatureCut, DividesLinesThatReturnToTheirNode)
{
  // A cam: its profile has one corner, so on the wall, which ends there, its outline is open, and on the ends it is a loop.
  SurfaceMesh cam;
  constexpr int Arc = 16;
  std::vector<Point> profile = { { 2.0, 0.0 } };
  for (int k = 0; k <= Arc; ++k)
  {
    const double angle = Pi / 3.0 + 4.0 * Pi / 3.0 * k / Arc;
    profile.emplace_back(std::cos(angle), std::sin(angle));
  }
  const auto count = static_cast<int>(profile.size());
  for (const double z : { 0.0, 1.0 })
  {
    for (const Point& at : profile)
    {
      cam.points.emplace_back(at.x(), at.y(), z);
    }
  }
  cam.points.emplace_back(0.0, 0.0, 0.0);
  cam.points.emplace_back(0.0, 0.0, 1.0);
  for (int i = 0; i < count; ++i)
  {
    const int j = (i + 1) % count;
    cam.triangles.push_back({ i, j, count + j });
    cam.triangles.push_back({ i, count + j, count + i });
    cam.triangles.push_back({ 2 * count, j, i });
    cam.triangles.push_back({ 2 * count + 1, count + i, count + j });
  }
  const CutSurface cut = CutOf(cam);
  EXPECT_EQ(cut.faces.size(), 3u);
  EXPECT_EQ(cut.lines.size(), 5u); // two halves at each end, and the edge of the corner
  EXPECT_EQ(cut.nodes.size(), 4u);
  ExpectLinesOf(cut);
  for (const FeatureLine& line : cut.lines)
  {
    EXPECT_FALSE(line.isClosed);
    for (const std::vector<int>& points : line.points)
    {
      EXPECT_NE(points.front(), points.back());
    }
  }
}

/// A narrow roof along y, whose ridge has an angle that depends on y.
template <typename AngleAt>
SurfaceMesh Roof(int rows, const AngleAt& angleAt)
{
  constexpr double Width = 0.01; // small beside rows, so that nothing else bends
  SurfaceMesh roof;
  for (int j = 0; j <= rows; ++j)
  {
    const double y = static_cast<double>(j) / rows;
    for (const int i : { -1, 0, 1 })
    {
      const double half = 0.5 * angleAt(y);
      roof.points.emplace_back(
        i * Width * std::cos(half), y, -std::abs(i) * Width * std::sin(half));
    }
    if (j < rows)
    {
      for (const int i : { 0, 1 })
      {
        const int a = 3 * j + i;
        roof.triangles.push_back({ a, a + 1, a + 4 });
        roof.triangles.push_back({ a, a + 4, a + 3 });
      }
    }
  }
  return roof;
}

TEST(FeatureCut, FollowsARidge)
{
  const double sharp = 0.5 * Pi;
  const CutSurface cut = CutOf(Roof(20, [&](double) { return sharp; }));
  EXPECT_EQ(cut.faces.size(), 2u);
  ASSERT_EQ(cut.lines.size(), 1u);
  EXPECT_FALSE(cut.lines[0].isClosed);
  ASSERT_EQ(cut.nodes.size(), 2u);
  EXPECT_TRUE(cut.nodes[0].isOnBoundary && cut.nodes[1].isOnBoundary);
  ExpectLinesOf(cut);
  // None is sharp enough.
  EXPECT_EQ(FindFeatureEdges(Roof(20, [](double) { return 0.5; }), DefaultFeatureAngle).count, 0u);
}

TEST(FeatureCut, ClosesGaps)
{
  const double blunt = 25.0 * Pi / 180.0;
  const SurfaceMesh roof =
    Roof(20, [&](double y) { return std::abs(y - 0.5) < 0.08 ? blunt : 0.5 * Pi; });
  const FeatureEdges features = FindFeatureEdges(roof, DefaultFeatureAngle);
  EXPECT_EQ(features.count, 20u);
  ASSERT_EQ(features.events.size(), 1u);
  EXPECT_EQ(features.events[0], "1 gap in a sharp edge was closed.");
  EXPECT_EQ(CutAlongFeatures(roof, features).faces.size(), 2u);
}

TEST(FeatureCut, LeavesOutLinesThatEnd)
{
  const SurfaceMesh roof =
    Roof(20, [](double y) { return 0.5 * Pi * std::clamp((0.9 - y) / 0.4, 0.0, 1.0); });
  const FeatureEdges features = FindFeatureEdges(roof, DefaultFeatureAngle);
  EXPECT_EQ(features.count, 0u);
  ASSERT_EQ(features.events.size(), 1u);
  EXPECT_NE(features.events[0].find("none is followed"), std::string::npos);
}

TEST(FeatureCut, MergesFaces)
{
  const SurfaceMesh box = BoxWithHoles(0, 3);
  FeatureEdges features = FindFeatureEdges(box, DefaultFeatureAngle);
  const CutSurface cut = CutAlongFeatures(box, features);
  std::vector<bool> joins(cut.faces.size(), false);
  joins.back() = true; // one of the two smallest, at an end
  MergeFaces(box, cut.faceOf, joins, features);
  const CutSurface merged = CutAlongFeatures(box, features);
  EXPECT_EQ(merged.faces.size(), 5u);
  EXPECT_EQ(merged.lines.size(), 11u);
  EXPECT_EQ(merged.nodes.size(), 8u); // two of them are corners of the new face alone
}

/// The can with its wall as region 1 and half of each circle, from x = 0 to x = 0, as line 3.
SurfaceMesh NamedCan()
{
  SurfaceMesh can = Can(8);
  for (const auto& v : can.triangles)
  {
    SpacePoint centre = SpacePoint::Zero();
    std::array<int, 3> lines{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const SpacePoint& from = can.points[static_cast<std::size_t>(v[i])];
      const SpacePoint& to = can.points[static_cast<std::size_t>(v[(i + 1) % 3])];
      centre += from / 3.0;
      const auto isOn = [](const SpacePoint& point)
      { return std::abs(point.z()) > 1.0 - 1e-12 && point.head<2>().norm() > 1.0 - 1e-12; };
      lines[i] = isOn(from) && isOn(to) && from.x() + to.x() > 0.0 ? 3 : -1;
    }
    can.regions.push_back(std::abs(centre.z()) < 1.0 - 1e-9 ? 1 : 0);
    can.lines.push_back(lines);
  }
  return can;
}

TEST(FeatureCut, DividesRegionsAndFollowsNamedLines)
{
  const SurfaceMesh can = NamedCan();
  // No edge is as sharp as 100°.
  const FeatureEdges features = FindFeatureEdges(can, 100.0 * Pi / 180.0);
  EXPECT_TRUE(features.events.empty());
  const CutSurface cut = CutAlongFeatures(can, features);
  EXPECT_EQ(cut.faces.size(), 3u);
  EXPECT_EQ(cut.nodes.size(), 4u); // where names change
  ASSERT_EQ(cut.lines.size(), 4u);
  EXPECT_EQ(std::count_if(cut.lines.begin(), cut.lines.end(),
              [](const FeatureLine& line) { return line.name == 3; }),
    2);
  for (const FeatureLine& line : cut.lines)
  {
    EXPECT_FALSE(line.isClosed);
    EXPECT_EQ(line.points[0].size(), 17u);
  }
  ExpectLinesOf(cut);
}

TEST(FeatureCut, NamesTheBoundary)
{
  // Of the hemisphere, half of the boundary has a name.
  SurfaceMesh half = Hemisphere(8);
  half.lines.assign(half.triangles.size(), { -1, -1, -1 });
  std::size_t named = 0;
  for (std::size_t t = 0; t < half.triangles.size(); ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const SpacePoint& from = half.points[static_cast<std::size_t>(half.triangles[t][i])];
      const SpacePoint& to = half.points[static_cast<std::size_t>(half.triangles[t][(i + 1) % 3])];
      if (std::abs(from.z()) + std::abs(to.z()) < 1e-12 && from.x() + to.x() > 0.0)
      {
        half.lines[t][i] = 0;
        ++named;
      }
    }
  }
  const CutSurface cut = CutOf(half);
  ASSERT_EQ(cut.faces.size(), 1u);
  EXPECT_TRUE(cut.lines.empty());
  ASSERT_EQ(cut.nodes.size(), 2u);
  for (const FeatureNode& node : cut.nodes)
  {
    EXPECT_TRUE(node.isOnBoundary);
    ASSERT_EQ(node.corners.size(), 1u);
    const auto point = static_cast<std::size_t>(node.corners.front().point);
    EXPECT_NEAR(cut.faces.front().points[point].x(), 0.0, 1e-12);
  }
  ASSERT_EQ(cut.boundaryNames.size(), 1u);
  EXPECT_EQ(cut.boundaryNames.front().size(), named);
}

TEST(FeatureCut, LeavesOutNamedLinesThatEndInside)
{
  SurfaceMesh sphere = CubedSphere(4);
  sphere.lines.assign(sphere.triangles.size(), { -1, -1, -1 });
  sphere.lines.front()[0] = 0;
  const FeatureEdges features = FindFeatureEdges(sphere, DefaultFeatureAngle);
  EXPECT_EQ(features.count, 0u);
  ASSERT_EQ(features.events.size(), 1u);
  EXPECT_NE(features.events.front().find("1 edge of a named line"), std::string::npos);
}
}
}
