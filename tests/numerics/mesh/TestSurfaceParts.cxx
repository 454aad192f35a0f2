#include "Support.h"
#include "SurfaceParts.h"
#include "SurfaceTopology.h"
#include "Surfaces.h"

#include <algorithm>
#include <array>
#include <map>
#include <string>

namespace crossfield::test
{
namespace
{
/// Returns the parts, all of which are surfaces.
SurfaceParts Found(const SurfaceMesh& surface)
{
  SurfaceParts result = FindSurfaceParts(surface);
  for (const SurfaceMesh& part : result.parts)
  {
    EXPECT_NO_THROW(SurfaceTopology topology(part));
  }
  return result;
}

int EulerCharacteristic(const SurfaceMesh& part)
{
  const SurfaceTopology topology(part);
  return topology.edges.EulerCharacteristic(topology.mesh);
}

double Volume(const SurfaceMesh& surface)
{
  double volume = 0.0;
  for (const auto& v : surface.triangles)
  {
    volume += surface.points[v[0]].cross(surface.points[v[1]]).dot(surface.points[v[2]]) / 6.0;
  }
  return volume;
}

/// Two copies, the second moved.
SurfaceMesh Two(SurfaceMesh surface, const SpacePoint& by)
{
  const std::size_t points = surface.points.size();
  const std::size_t triangles = surface.triangles.size();
  for (std::size_t p = 0; p < points; ++p)
  {
    surface.points.push_back(surface.points[p] + by);
  }
  for (std::size_t t = 0; t < triangles; ++t)
  {
    auto triangle = surface.triangles[t];
    for (int& vertex : triangle)
    {
      vertex += static_cast<int>(points);
    }
    surface.triangles.push_back(triangle);
  }
  return surface;
}

TEST(SurfaceParts, LeaveAGoodSurfaceAsItIs)
{
  for (const SurfaceMesh& surface : { CubedSphere(3), Hemisphere(4), Torus(2.5, 8, 6) })
  {
    const SurfaceParts found = Found(surface);
    ASSERT_EQ(found.parts.size(), 1u);
    EXPECT_TRUE(found.events.empty());
    EXPECT_EQ(found.parts[0].triangles.size(), surface.triangles.size());
    EXPECT_EQ(found.parts[0].points.size(), surface.points.size());
  }
}

TEST(SurfaceParts, TurnTrianglesOutwards)
{
  Random random(11);
  SurfaceMesh sphere = CubedSphere(4);
  for (auto& triangle : sphere.triangles)
  {
    if (random.Integer(0, 2) > 0)
    {
      std::swap(triangle[0], triangle[1]);
    }
  }
  const SurfaceParts found = Found(sphere);
  EXPECT_NEAR(Volume(found.parts[0]), Volume(CubedSphere(4)), 1e-12);
  ASSERT_EQ(found.events.size(), 1u);
  EXPECT_NE(found.events[0].find("turned over"), std::string::npos);
}

TEST(SurfaceParts, KeepTheOrientationOfMostTrianglesOfAnOpenSurface)
{
  SurfaceMesh half = Hemisphere(4);
  std::swap(half.triangles[5][0], half.triangles[5][1]);
  EXPECT_EQ(Found(half).events, std::vector<std::string>{ "1 triangle was turned over." });
}

TEST(SurfaceParts, AreSortedByArea)
{
  SurfaceMesh both = Two(CubedSphere(3), { 3.0, 0.0, 0.0 });
  for (std::size_t p = both.points.size() / 2; p < both.points.size(); ++p)
  {
    both.points[p] *= 2.0;
  }
  const SurfaceParts found = Found(both);
  ASSERT_EQ(found.parts.size(), 2u);
  EXPECT_GT(Volume(found.parts[0]), 7.0 * Volume(found.parts[1]));
}

TEST(SurfaceParts, RemoveRepeatedTriangles)
{
  SurfaceMesh sphere = CubedSphere(3);
  const std::size_t count = sphere.triangles.size();
  sphere.triangles.push_back(sphere.triangles[4]);
  sphere.triangles.push_back({ 3, 3, 5 });
  const SurfaceParts found = Found(sphere);
  EXPECT_EQ(found.parts[0].triangles.size(), count);
  EXPECT_EQ(found.events,
    std::vector<std::string>{
      "2 triangles were removed, because given twice or with a point twice." });
}

TEST(SurfaceParts, DivideWhatIsBeyondAFlatTriangle)
{
  // The midpoint of a side of one triangle, joined to the third corner of the one and not of the other.
  SurfaceMesh sphere = CubedSphere(3);
  const auto triangle = sphere.triangles[7];
  const int middle = static_cast<int>(sphere.points.size());
  sphere.points.push_back(0.5 * (sphere.points[triangle[0]] + sphere.points[triangle[1]]));
  sphere.triangles[7] = { triangle[0], middle, triangle[2] };
  sphere.triangles.push_back({ middle, triangle[1], triangle[2] });
  sphere.triangles.push_back(
    { triangle[0], triangle[1], middle }); // closes the gap without an area
  const std::size_t count = sphere.triangles.size();
  const SurfaceParts found = Found(sphere);
  EXPECT_EQ(found.parts[0].triangles.size(), count); // one less and one more
  EXPECT_EQ(EulerCharacteristic(found.parts[0]), 2);
  EXPECT_EQ(
    found.events, std::vector<std::string>{ "1 triangle was removed, because without an area." });
}

TEST(SurfaceParts, SeparateWhatMeetsInAPoint)
{
  // Two spheres that share a point.
  SurfaceMesh both = Two(CubedSphere(3), { 2.0, 0.0, 0.0 });
  const std::size_t half = both.triangles.size() / 2;
  const auto farthest = std::max_element(both.points.begin(),
    both.points.begin() + static_cast<std::ptrdiff_t>(both.points.size() / 2),
    [](const SpacePoint& a, const SpacePoint& b) { return a.x() < b.x(); });
  const int shared = static_cast<int>(farthest - both.points.begin());
  const int replaced = both.triangles[half][0];
  for (std::size_t t = half; t < both.triangles.size(); ++t)
  {
    std::replace(both.triangles[t].begin(), both.triangles[t].end(), replaced, shared);
  }
  const SurfaceParts found = Found(both);
  EXPECT_EQ(found.parts.size(), 2u);
  ASSERT_EQ(found.events.size(), 1u);
  EXPECT_NE(found.events[0].find("1 point was added"), std::string::npos);
}

TEST(SurfaceParts, RefuseWhatIsNoSurface)
{
  SurfaceMesh fin = CubedSphere(3);
  fin.points.push_back({ 3.0, 0.0, 0.0 });
  const auto edge = fin.triangles.front();
  fin.triangles.push_back({ edge[0], edge[1], static_cast<int>(fin.points.size()) - 1 });
  EXPECT_TRUE(Refuses([&] { FindSurfaceParts(fin); }, { "The edge from (", "has 3 triangles" }));

  SurfaceMesh strip; // with half a turn
  constexpr int N = 12;
  for (int i = 0; i < N; ++i)
  {
    const double u = 2.0 * Pi * i / N;
    for (const double side : { -0.3, 0.3 })
    {
      const double radius = 1.0 + side * std::cos(0.5 * u);
      strip.points.push_back(
        { radius * std::cos(u), radius * std::sin(u), side * std::sin(0.5 * u) });
    }
    const int next = 2 * (i + 1) % (2 * N);
    const bool closes = i + 1 == N;
    const int a = closes ? next + 1 : next;
    const int b = closes ? next : next + 1;
    strip.triangles.push_back({ 2 * i, a, 2 * i + 1 });
    strip.triangles.push_back({ 2 * i + 1, a, b });
  }
  EXPECT_TRUE(Refuses([&] { FindSurfaceParts(strip); }, { "only one side", "cut it there" }));

  SurfaceMesh touching; // two triangles that share a corner
  touching.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 1 }, { -1, 0, 0 }, { -1, -1, 0 } };
  touching.triangles = { { 0, 1, 2 }, { 0, 3, 4 } };
  EXPECT_TRUE(
    Refuses([&] { FindSurfaceParts(touching); }, { "touches itself in the point (0, 0, 0)" }));

  SurfaceMesh none;
  none.points = { { 0, 0, 0 }, { 1, 0, 0 }, { 2, 0, 0 } };
  none.triangles = { { 0, 1, 2 } };
  EXPECT_TRUE(Refuses([&] { FindSurfaceParts(none); }, { "no triangle with an area" }));
}

TEST(SurfaceParts, KeepRegionsAndLines)
{
  // A square whose lower half ends with a triangle without an area, beyond which the upper half is one triangle; the
  // line between them leads along its longest side. The triangle above is given twice, the one below turned over.
  SurfaceMesh square;
  square.points = { { 0.0, 0.0, 0.0 }, { 1.0, 0.0, 0.0 }, { 2.0, 0.0, 0.0 }, { 1.0, 1.0, 0.0 },
    { 1.0, -1.0, 0.0 } };
  square.triangles = { { 0, 2, 3 }, { 0, 1, 2 }, { 2, 3, 0 }, { 1, 0, 4 }, { 4, 2, 1 } };
  square.regions = { 1, 0, 1, 2, 2 };
  square.lines = { { 3, -1, 4 }, { -1, -1, -1 }, { -1, -1, -1 }, { -1, 5, -1 }, { -1, -1, -1 } };
  const SurfaceParts found = Found(square);
  ASSERT_EQ(found.parts.size(), 1u);
  const SurfaceMesh& part = found.parts.front();
  ASSERT_EQ(part.triangles.size(), 4u);
  ASSERT_EQ(part.regions.size(), 4u);
  ASSERT_EQ(part.lines.size(), 4u);
  EXPECT_EQ(std::count(part.regions.begin(), part.regions.end(), 1), 2);
  EXPECT_EQ(std::count(part.regions.begin(), part.regions.end(), 2), 2);
  std::map<std::string, int> lineAt; // by the middles of edges
  for (std::size_t t = 0; t < 4; ++t)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const SpacePoint middle = 0.5 *
        (part.points[static_cast<std::size_t>(part.triangles[t][i])] +
          part.points[static_cast<std::size_t>(part.triangles[t][(i + 1) % 3])]);
      int& line = lineAt.emplace(DescribeInSpace(middle), -1).first->second;
      line = std::max(line, part.lines[t][i]);
    }
  }
  const auto at = [&](double x, double y) { return lineAt.at(DescribeInSpace({ x, y, 0.0 })); };
  EXPECT_EQ(at(0.5, 0.0), 3);
  EXPECT_EQ(at(1.5, 0.0), 3);
  EXPECT_EQ(at(0.5, 0.5), 4);
  EXPECT_EQ(at(1.5, 0.5), -1);
  EXPECT_EQ(at(0.5, -0.5), 5);
  EXPECT_EQ(at(1.0, 0.5), -1);
}
}
}
