#include "FactoredDomain.h"

#include "MeshForPoints.h"
#include "Support.h"
#include "TriangleArea.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
double MinimumAngle(const TriangleMesh& mesh)
{
  double minimum = Pi;
  for (const auto& v : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Point& at = mesh.points[static_cast<std::size_t>(v[i])];
      minimum = std::min(minimum,
        AngleBetween(mesh.points[static_cast<std::size_t>(v[(i + 1) % 3])] - at,
          mesh.points[static_cast<std::size_t>(v[(i + 2) % 3])] - at));
    }
  }
  return minimum;
}

double Area(const TriangleMesh& mesh)
{
  double area = 0.0;
  for (const auto& triangle : mesh.triangles)
  {
    area += TriangleArea(mesh, triangle);
  }
  return area;
}

Configuration At(const std::vector<Point>& points)
{
  Configuration configuration;
  for (const Point& point : points)
  {
    configuration.push_back({ point, 1 });
  }
  return configuration;
}

TEST(FactoredDomain, InsertsVertices)
{
  const FactoredDomain ring(Builtin("ring", 0.08), {}, 0.08);
  const PlanarTopology& base = ring.GetPotential()->GetTopology();
  Random random(41);
  for (int i = 0; i < 300; ++i)
  {
    SCOPED_TRACE(i);
    std::vector<Point> points;
    while (points.size() < 5)
    {
      const double radius = random.Uniform(0.6, 0.8);
      const double angle = random.Uniform(-Pi, Pi);
      const Point point = radius * Point(std::cos(angle), std::sin(angle));
      if (std::all_of(points.begin(), points.end(),
            [&](const Point& other) { return (other - point).norm() > 0.2; }))
      {
        points.push_back(point);
      }
    }
    const TriangleMesh mesh = ring.MeshOn(At(points));
    const PlanarTopology topology(mesh); // throws if the mesh is invalid
    EXPECT_EQ(topology.edges.EulerCharacteristic(mesh), 0);
    EXPECT_NEAR(Area(mesh), Area(base.mesh), 1e-12);
    EXPECT_EQ(topology.loops.size(), 2u);
    for (std::size_t loop = 0; loop < 2; ++loop)
    {
      EXPECT_EQ(topology.loops[loop].kind, base.loops[loop].kind);
      EXPECT_EQ(topology.loops[loop].edges.size(), base.loops[loop].edges.size());
    }
    // Almost every inserted vertex replaces one.
    EXPECT_NEAR(
      static_cast<double>(mesh.points.size()), static_cast<double>(base.mesh.points.size()), 5.0);
    EXPECT_GT(MinimumAngle(mesh), 0.15);
    for (const Point& point : points)
    {
      EXPECT_EQ(std::count(mesh.points.begin(), mesh.points.end(), point), 1);
    }
  }
}

TEST(FactoredDomain, KeepsVertexCountForExistingVertices)
{
  const FactoredDomain disk(Builtin("disk", 0.1), {}, 0.1);
  const PlanarTopology& base = disk.GetPotential()->GetTopology();
  int tried = 0;
  for (const Point& vertex : base.mesh.points)
  {
    if (vertex.norm() > 0.7)
    {
      continue;
    }
    ++tried;
    const TriangleMesh mesh = disk.MeshOn(At({ vertex }));
    EXPECT_EQ(mesh.points.size(), base.mesh.points.size());
    EXPECT_EQ(mesh.triangles.size(), base.mesh.triangles.size());
  }
  EXPECT_GT(tried, 50);
}

TEST(FactoredDomain, MeshesAgainIfPointsAreClose)
{
  const FactoredDomain disk(Builtin("disk", 0.1), {}, 0.1);
  for (const Configuration& close : { At({ { 0.0, 0.0 }, { 0.03, 0.01 } }), At({ { 0.97, 0.0 } }) })
  {
    EXPECT_EQ(disk.MeshOn(close).points, MeshThroughPoints(disk.GetDomain(), close, 0.1).points);
  }
}

TEST(FactoredDomain, ChecksVerticesOnBoundary)
{
  const PlanarDomain square = Builtin("square", 0.1);
  const Configuration onSide = At({ { 0.123, 0.0 } });
  EXPECT_FALSE(FactoredDomain(square, {}, 0.1).HasBoundaryVertices(onSide));
  EXPECT_TRUE(FactoredDomain(square, onSide, 0.1).HasBoundaryVertices(onSide));
  EXPECT_TRUE(
    FactoredDomain(square, onSide, 0.1).HasBoundaryVertices(At({ { 0.5, 0.5 }, { 0.0, 0.0 } })));
}
}
}
