#include "Support.h"
#include "TriangleOrder.h"

#include <algorithm>
#include <map>
#include <utility>

namespace crossfield::test
{
namespace
{
using Corners = std::array<std::pair<double, double>, 3>;

/// The triangles as places, whatever the numbers.
std::vector<Corners> Places(const TriangleMesh& mesh)
{
  std::vector<Corners> places;
  for (const auto& triangle : mesh.triangles)
  {
    Corners corners;
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Point& point = mesh.points[static_cast<std::size_t>(triangle[i])];
      corners[i] = { point.x(), point.y() };
    }
    places.push_back(corners);
  }
  std::sort(places.begin(), places.end());
  return places;
}

TEST(TriangleOrder, KeepsTheMesh)
{
  TriangleMesh mesh = DrillMesh(Builtin("ring", 0.1), { { { 0.75, 0.05 }, 1, 0.05 } }, 0.1);
  mesh.points.insert(mesh.points.begin(), Point(7.0, 7.0)); // which no triangle uses
  for (auto& triangle : mesh.triangles)
  {
    triangle = { triangle[0] + 1, triangle[1] + 1, triangle[2] + 1 };
  }
  for (BoundaryEdge& edge : mesh.boundary)
  {
    edge.vertices = { edge.vertices[0] + 1, edge.vertices[1] + 1 };
  }
  const TriangleMesh ordered = OrderTriangles(mesh);
  EXPECT_EQ(Places(ordered), Places(mesh)) << "to the last bit, and from the same corner on";
  ASSERT_EQ(ordered.points.size(), mesh.points.size());
  EXPECT_EQ(ordered.points.back(), Point(7.0, 7.0));
  ASSERT_EQ(ordered.boundary.size(), mesh.boundary.size());
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    for (std::size_t end = 0; end < 2; ++end)
    {
      EXPECT_EQ(ordered.points[static_cast<std::size_t>(ordered.boundary[i].vertices[end])],
        mesh.points[static_cast<std::size_t>(mesh.boundary[i].vertices[end])]);
    }
    EXPECT_EQ(ordered.boundary[i].kind, mesh.boundary[i].kind);
    EXPECT_EQ(ordered.boundary[i].id, mesh.boundary[i].id);
  }
  const TriangleMesh again = OrderTriangles(ordered);
  EXPECT_EQ(again.triangles, ordered.triangles) << "it is the order already";
}

TEST(TriangleOrder, NumbersPointsByFirstUse)
{
  const TriangleMesh mesh = OrderTriangles(DrillMesh(Builtin("disk", 0.1), {}, 0.1));
  int next = 0;
  for (const auto& triangle : mesh.triangles)
  {
    for (const int point : triangle)
    {
      ASSERT_LE(point, next);
      next = std::max(next, point + 1);
    }
  }
  EXPECT_EQ(next, static_cast<int>(mesh.points.size()));
}

TEST(TriangleOrder, FollowsTheCurve)
{
  // Two triangles in each square of a grid of 8 by 8, counted in rows: in the order of the curve each square has a side
  // in common with the next.
  constexpr int Side = 8;
  TriangleMesh mesh;
  for (int y = 0; y <= Side; ++y)
  {
    for (int x = 0; x <= Side; ++x)
    {
      mesh.points.emplace_back(x, y);
    }
  }
  for (int y = 0; y < Side; ++y)
  {
    for (int x = 0; x < Side; ++x)
    {
      const int low = x + (Side + 1) * y;
      const int high = low + Side + 1;
      mesh.triangles.push_back({ low, low + 1, high });
      mesh.triangles.push_back({ high, low + 1, high + 1 });
    }
  }
  const TriangleMesh ordered = OrderTriangles(mesh);
  ASSERT_EQ(ordered.triangles.size(), 2u * Side * Side);
  const auto square = [&ordered](std::size_t t)
  {
    Point sum(0.0, 0.0);
    for (const int point : ordered.triangles[t])
    {
      sum += ordered.points[static_cast<std::size_t>(point)] / 3.0;
    }
    return Point(std::floor(sum.x()), std::floor(sum.y()));
  };
  for (std::size_t t = 1; t < ordered.triangles.size(); ++t)
  {
    EXPECT_EQ((square(t) - square(t - 1)).lpNorm<1>(), t % 2 == 0 ? 1.0 : 0.0) << t;
  }
}
}
}
