#include "PointInsertion.h"

#include "Error.h"
#include "Support.h"
#include "TriangleArea.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
double LeastAngle(const TriangleMesh& mesh)
{
  double least = Pi;
  for (const auto& v : mesh.triangles)
  {
    for (std::size_t i = 0; i < 3; ++i)
    {
      const Point& at = mesh.points[static_cast<std::size_t>(v[i])];
      least = std::min(least,
        AngleBetween(mesh.points[static_cast<std::size_t>(v[(i + 1) % 3])] - at,
          mesh.points[static_cast<std::size_t>(v[(i + 2) % 3])] - at));
    }
  }
  return least;
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

TEST(PointInsertion, MakesAValidMeshWithTheSameBoundary)
{
  DrillOptions options;
  options.meshSize = 0.1;
  const SharedTopology base = ShareTopology(DrillHoles(Builtin("ring", 0.1), {}, options));
  Random random(41);
  for (int i = 0; i < 300; ++i)
  {
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
    const TriangleMesh mesh = InsertPoints(*base, points);
    const MeshTopology topology(mesh); // throws unless it is a mesh
    EXPECT_EQ(topology.edges.EulerCharacteristic(mesh), 0);
    EXPECT_NEAR(Area(mesh), Area(base->mesh), 1e-12);
    EXPECT_EQ(topology.AlignedLoops(), base->AlignedLoops());
    // Short edges at inserted points are no harm, triangles without height are.
    EXPECT_GT(LeastAngle(mesh), 0.02) << i;
    for (const Point& point : points)
    {
      EXPECT_EQ(std::count(mesh.points.begin(), mesh.points.end(), point), 1);
    }
  }
}

TEST(PointInsertion, TakesVerticesAndPointsOnEdges)
{
  DrillOptions options;
  options.meshSize = 0.1;
  const SharedTopology base = ShareTopology(DrillHoles(Builtin("disk", 0.1), {}, options));
  int tried = 0;
  for (int e = 0; e < base->edges.Count(); ++e)
  {
    const auto& [a, b] = base->edges.vertices[static_cast<std::size_t>(e)];
    if (base->PointAt(a).norm() > 0.7 || base->PointAt(b).norm() > 0.7)
    {
      continue;
    }
    ++tried;
    const TriangleMesh atVertex = InsertPoints(*base, { base->PointAt(a) });
    EXPECT_EQ(atVertex.points, base->mesh.points);
    EXPECT_EQ(atVertex.triangles, base->mesh.triangles);
    const TriangleMesh onEdge = InsertPoints(*base, { base->Midpoint(e) });
    EXPECT_NO_THROW(MeshTopology{ onEdge });
    EXPECT_GT(LeastAngle(onEdge), 0.1);
  }
  EXPECT_GT(tried, 100);
}

TEST(PointInsertion, RefusesWhatIsOutside)
{
  const SharedTopology base = ShareTopology(DrillHoles(Builtin("ring", 0.1), {}));
  EXPECT_THROW(InsertPoints(*base, { Point(0.0, 0.0) }), Error);
}
}
}
