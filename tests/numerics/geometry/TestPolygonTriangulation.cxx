#include "PolygonTriangulation.h"

#include "Support.h"

#include <cmath>

namespace crossfield::test
{
namespace
{
/// Expects the number of triangles of a triangulated polygon, positive areas and their sum.
void ExpectFills(const Loop& polygon, std::size_t collinear = 0)
{
  const auto triangles = TriangulatePolygon(polygon);
  EXPECT_EQ(triangles.size(), polygon.size() - 2 - collinear);
  double sum = 0.0;
  for (const auto& [i, j, k] : triangles)
  {
    const auto at = [&polygon](int v) { return polygon[static_cast<std::size_t>(v)]; };
    const double area = 0.5 * Cross(at(j) - at(i), at(k) - at(i));
    EXPECT_GT(area, 0.0);
    sum += area;
  }
  EXPECT_NEAR(sum, SignedArea(polygon), 1e-13 * SignedArea(polygon));
}
}

TEST(PolygonTriangulation, FillsConvexAndConcavePolygons)
{
  ExpectFills(RegularPolygon(30));
  ExpectFills({ { 0.0, 0.0 }, { 2.0, 0.0 }, { 2.0, 1.0 }, { 1.0, 0.2 }, { 0.0, 1.0 } });
  Random random(71);
  for (int round = 0; round < 20; ++round)
  {
    Loop star;
    for (int i = 0; i < 60; ++i)
    {
      const double radius = random.Uniform(0.2, 1.0);
      star.emplace_back(radius * std::cos(Pi * i / 30.0), radius * std::sin(Pi * i / 30.0));
    }
    ExpectFills(star);
  }
}

TEST(PolygonTriangulation, FillsARingThatIsCutOpen)
{
  Loop ring = RegularPolygon(40);
  Loop inner = RegularPolygon(40, 0.4);
  ring.push_back(ring.front());
  ring.push_back(inner.front());
  ring.insert(ring.end(), inner.rbegin(), inner.rend());
  ExpectFills(ring);
}

TEST(PolygonTriangulation, AcceptsCollinearPoints)
{
  ExpectFills(
    { { 0.0, 0.0 }, { 0.5, 0.0 }, { 1.0, 0.0 }, { 1.0, 0.5 }, { 1.0, 1.0 }, { 0.0, 1.0 } });
  EXPECT_TRUE(TriangulatePolygon({ { 0.0, 0.0 }, { 1.0, 0.0 }, { 2.0, 0.0 } }).empty());
  EXPECT_TRUE(TriangulatePolygon({}).empty());
}
}
