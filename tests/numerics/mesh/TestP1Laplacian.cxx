#include "DrillHoles.h"
#include "P1Laplacian.h"
#include "Support.h"

namespace crossfield::test
{
namespace
{
TriangleMesh MeshOfSquare()
{
  return DrillHoles(Builtin("ring"), { { { 0.7, 0.1 }, 1, 0.01 }, { { -0.6, 0.3 }, -1, 0.15 } });
}

TEST(P1Laplacian, PatchTestIsExactForLinearFunctions)
{
  const TriangleMesh mesh = MeshOfSquare();
  const SparseMatrix stiffness = P1Stiffness(PlanarTopology(mesh));
  EXPECT_TRUE(stiffness.isCompressed());
  std::vector<bool> onBoundary(mesh.points.size(), false);
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    onBoundary[edge.vertices[0]] = true;
  }
  const Point slope(0.8, -1.9);
  Eigen::VectorXd u(mesh.points.size());
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    u[v] = 5.0 + slope.dot(mesh.points[v]);
  }
  const Eigen::VectorXd residual = stiffness * u;
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    if (!onBoundary[v])
    {
      ASSERT_NEAR(residual[v], 0.0, 1e-12);
    }
  }
  const double energy = 0.5 * slope.squaredNorm() * MeshArea(mesh);
  EXPECT_NEAR(0.5 * u.dot(residual), energy, 1e-12 * energy);
}

TEST(P1Laplacian, IsSymmetricWithTheConstantsAsKernelAtAnyScale)
{
  const TriangleMesh mesh = MeshOfSquare();
  const SparseMatrix stiffness = P1Stiffness(PlanarTopology(mesh));
  const SparseMatrix transposed = stiffness.transpose();
  EXPECT_LE((stiffness - transposed).norm(), 1e-14 * stiffness.norm());
  EXPECT_LE((stiffness * Eigen::VectorXd::Ones(stiffness.cols())).lpNorm<Eigen::Infinity>(), 1e-12);
  for (const double scale : { 1e-6, 1e6 })
  {
    const SparseMatrix moved =
      P1Stiffness(PlanarTopology(Similarity{ 0.4, scale, Point::Zero() }(mesh)));
    EXPECT_LE((moved - stiffness).norm(), 1e-11 * stiffness.norm());
  }
}

TEST(P1Laplacian, ElementIsAQuarterOfTheCrouzeixRaviartOne)
{
  const TriangleMesh mesh = MeshOfSquare();
  for (std::size_t t = 0; t < mesh.triangles.size(); t += 7)
  {
    TriangleMesh single;
    for (int i = 0; i < 3; ++i)
    {
      single.points.push_back(mesh.points[mesh.triangles[t][i]]);
      single.boundary.push_back({ { i, (i + 1) % 3 }, BoundaryKind::Outer, 0, 0 });
    }
    single.triangles = { { 0, 1, 2 } };
    const EdgeNumbering edges = NumberEdges(single);
    const Eigen::MatrixXd other = CrouzeixRaviartStiffness(single, edges);
    const Eigen::Matrix3d element =
      P1ElementStiffness({ single.points[0], single.points[1], single.points[2] });
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        // Vertex i is opposite edge i + 1.
        const int e = edges.ofTriangle[0][(i + 1) % 3];
        const int f = edges.ofTriangle[0][(j + 1) % 3];
        EXPECT_NEAR(4.0 * element(i, j), other(e, f), 1e-12 * other.norm());
      }
    }
  }
}

TEST(P1Laplacian, RefusesTrianglesWithoutArea)
{
  TriangleMesh mesh = MeshOfSquare();
  mesh.points[mesh.triangles[5][0]] = mesh.points[mesh.triangles[5][1]];
  EXPECT_TRUE(Refuses([&] { P1Stiffness(PlanarTopology(mesh)); }, { "Triangle", "no area" }));
}
}
}
