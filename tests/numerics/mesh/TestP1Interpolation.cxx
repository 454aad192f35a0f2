// Linear functions are interpolated exactly, at every point of a mesh; outside, the nearest point
// counts.

#include "P1Interpolation.h"

#include "Support.h"

namespace crossfield::test
{
namespace
{
Eigen::VectorXd ValuesOf(const TriangleMesh& mesh, double (*function)(const Point&))
{
  Eigen::VectorXd values(static_cast<Eigen::Index>(mesh.points.size()));
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    values[static_cast<Eigen::Index>(v)] = function(mesh.points[v]);
  }
  return values;
}

double Linear(const Point& place)
{
  return 2.0 + 3.0 * place.x() - 5.0 * place.y();
}

TEST(P1Interpolation, IsExactForLinearFunctions)
{
  const TriangleMesh mesh = DrillMesh(LShape(), {}, 0.2);
  const P1Interpolation interpolation(mesh, ValuesOf(mesh, Linear));
  Random random(1);
  for (int i = 0; i < 1000; ++i)
  {
    const auto& triangle = mesh.triangles[static_cast<std::size_t>(
      random.Integer(0, static_cast<int>(mesh.triangles.size()) - 1))];
    const double s = random.Uniform(0.0, 1.0);
    const double t = random.Uniform(0.0, 1.0 - s);
    const auto point = [&](std::size_t k)
    { return mesh.points[static_cast<std::size_t>(triangle[k])]; };
    const Point place = (1.0 - s - t) * point(0) + s * point(1) + t * point(2);
    EXPECT_NEAR(interpolation.At(place), Linear(place), 1e-13);
  }
  for (const Point& point : mesh.points)
  {
    EXPECT_NEAR(interpolation.At(point), Linear(point), 1e-13);
  }
}

TEST(P1Interpolation, UsesTheNearestPointOutside)
{
  const TriangleMesh mesh = DrillMesh(LShape(), {}, 0.2);
  const P1Interpolation interpolation(mesh, ValuesOf(mesh, Linear));
  // The L is [0, 2]² without (1, 2]².
  EXPECT_NEAR(interpolation.At({ -3.0, 0.7 }), Linear({ 0.0, 0.7 }), 1e-13);
  EXPECT_NEAR(interpolation.At({ -1.0, -2.0 }), Linear({ 0.0, 0.0 }), 1e-13);
  EXPECT_NEAR(interpolation.At({ 1.4, 1.3 }), Linear({ 1.4, 1.0 }), 1e-13);
  EXPECT_NEAR(interpolation.At({ 100.0, 0.5 }), Linear({ 2.0, 0.5 }), 1e-13);
}

TEST(P1Interpolation, FindsTrianglesOfAThinDomain)
{
  TriangleMesh mesh;
  mesh.points = { { 0.0, 0.0 }, { 1000.0, 0.0 }, { 1000.0, 1e-3 }, { 0.0, 1e-3 } };
  mesh.triangles = { { 0, 1, 2 }, { 0, 2, 3 } };
  const P1Interpolation interpolation(mesh, ValuesOf(mesh, Linear));
  for (const Point& place : { Point(10.0, 5e-4), Point(999.0, 1e-4), Point(500.0, 0.0) })
  {
    EXPECT_NEAR(interpolation.At(place), Linear(place), 1e-9);
  }
}
}
}
