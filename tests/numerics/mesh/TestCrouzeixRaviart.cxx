#include "DrillHoles.h"
#include "Support.h"

#include <Eigen/SparseCholesky>

#include <cmath>

namespace crossfield::test
{
namespace
{
using RealFunction = std::function<double(const Point&)>;

Eigen::VectorXd AtMidpoints(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const RealFunction& f)
{
  Eigen::VectorXd values(edges.Count());
  for (int e = 0; e < edges.Count(); ++e)
  {
    values[e] = f(Midpoint(mesh, edges, e));
  }
  return values;
}

std::vector<bool> OnBoundary(const EdgeNumbering& edges)
{
  std::vector<bool> result(edges.vertices.size(), false);
  for (int edge : edges.ofBoundary)
  {
    result[edge] = true;
  }
  return result;
}

/// Returns a mesh with an inner loop, holes and triangles of very different sizes.
TriangleMesh TestMesh()
{
  return DrillHoles(Builtin("ring"), { { { 0.7, 0.1 }, 1, 0.01 }, { { -0.6, 0.3 }, -1, 0.15 } });
}

TEST(CrouzeixRaviart, PatchTestIsExactForLinearFunctions)
{
  const TriangleMesh mesh = TestMesh();
  const EdgeNumbering edges = NumberEdges(mesh);
  const SparseMatrix stiffness = CrouzeixRaviartStiffness(mesh, edges);
  const std::vector<bool> boundary = OnBoundary(edges);
  const Point slope(1.7, -0.4);
  const Eigen::VectorXd u =
    AtMidpoints(mesh, edges, [&](const Point& x) { return 3.0 + slope.dot(x); });
  const Eigen::VectorXd residual = stiffness * u;
  for (int e = 0; e < edges.Count(); ++e)
  {
    if (!boundary[e])
    {
      ASSERT_NEAR(residual[e], 0.0, 1e-12);
    }
  }
  // ½ uᵀ K u = ½ ∫ |∇u|².
  const double energy = 0.5 * slope.squaredNorm() * MeshArea(mesh);
  EXPECT_NEAR(0.5 * u.dot(residual), energy, 1e-12 * energy);
}

TEST(CrouzeixRaviart, BoundaryResidualIsTheFluxThroughTheEdge)
{
  // ∫ ∇u · ∇ψ_e = flux through e, for linear u on a boundary edge: |e| ∂u/∂ν.
  const TriangleMesh mesh = TestMesh();
  const EdgeNumbering edges = NumberEdges(mesh);
  const Point slope(-0.3, 2.1);
  const Eigen::VectorXd residual = CrouzeixRaviartStiffness(mesh, edges) *
    AtMidpoints(mesh, edges, [&](const Point& x) { return slope.dot(x); });
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const auto& [from, to] = mesh.boundary[i].vertices;
    // The domain is on the left, so the outward normal times the length is the edge rotated to the
    // right.
    const double flux = Cross(slope, mesh.points[to] - mesh.points[from]);
    EXPECT_NEAR(residual[edges.ofBoundary[i]], flux, 1e-12);
  }
}

TEST(CrouzeixRaviart, IsSymmetricAndPositiveSemidefiniteWithTheConstantsAsKernel)
{
  Random random(9);
  const TriangleMesh mesh = TestMesh();
  const EdgeNumbering edges = NumberEdges(mesh);
  const SparseMatrix stiffness = CrouzeixRaviartStiffness(mesh, edges);
  const SparseMatrix transposed = stiffness.transpose();
  EXPECT_LE((stiffness - transposed).norm(), 1e-14 * stiffness.norm());
  EXPECT_LE((stiffness * Eigen::VectorXd::Ones(edges.Count())).lpNorm<Eigen::Infinity>(), 1e-12);
  for (int trial = 0; trial < 20; ++trial)
  {
    Eigen::VectorXd u(edges.Count());
    for (double& value : u)
    {
      value = random.Uniform(-1.0, 1.0);
    }
    EXPECT_GT(u.dot(stiffness * u), 0.0);
  }
  // The kernel contains nothing else: on the functions that vanish on one edge the matrix is
  // definite.
  const Eigen::SimplicialLLT<SparseMatrix> factor(
    SparseMatrix(stiffness.bottomRightCorner(edges.Count() - 1, edges.Count() - 1)));
  EXPECT_EQ(factor.info(), Eigen::Success);
}

TEST(CrouzeixRaviart, IsInvariantUnderSimilarities)
{
  const TriangleMesh mesh = TestMesh();
  const EdgeNumbering edges = NumberEdges(mesh);
  const SparseMatrix stiffness = CrouzeixRaviartStiffness(mesh, edges);
  for (const Similarity& move : { Similarity{ 0.0, 1e-6, Point::Zero() },
         Similarity{ 0.0, 1e6, Point::Zero() }, Similarity{ 1.1, 1.0, Point(-3.0, 2.0) } })
  {
    const SparseMatrix moved = CrouzeixRaviartStiffness(move(mesh), edges);
    EXPECT_LE((moved - stiffness).norm(), 1e-11 * stiffness.norm());
  }
}

TEST(CrouzeixRaviart, IsFourTimesTheLinearElement)
{
  // The P1 matrix in its cotangent form, K_ij = −½ cot(angle opposite ij): an independent formula.
  Random random(10);
  for (int trial = 0; trial < 200; ++trial)
  {
    TriangleMesh mesh;
    for (int i = 0; i < 3; ++i)
    {
      mesh.points.emplace_back(random.Uniform(-1.0, 1.0), random.Uniform(-1.0, 1.0));
      mesh.boundary.push_back({ { i, (i + 1) % 3 }, BoundaryKind::Outer, 0, 0 });
    }
    mesh.triangles = { { 0, 1, 2 } };
    if (TriangleArea(mesh, 0) < 0.0)
    {
      std::swap(mesh.points[1], mesh.points[2]);
    }
    if (SmallestAngle(mesh) < 1.0)
    {
      continue;
    }
    Eigen::Matrix3d linear = Eigen::Matrix3d::Zero();
    for (int i = 0; i < 3; ++i)
    {
      const int j = (i + 1) % 3;
      const int opposite = (i + 2) % 3;
      const Point a = mesh.points[i] - mesh.points[opposite];
      const Point b = mesh.points[j] - mesh.points[opposite];
      const double half = 0.5 * a.dot(b) / Cross(a, b);
      linear(i, j) = linear(j, i) = -half;
      linear(i, i) += half;
      linear(j, j) += half;
    }
    const EdgeNumbering edges = NumberEdges(mesh);
    const Eigen::MatrixXd matrix = CrouzeixRaviartStiffness(mesh, edges);
    for (int i = 0; i < 3; ++i)
    {
      for (int j = 0; j < 3; ++j)
      {
        // ψ of the edge opposite vertex v is 1 − 2 λ_v; edge i of the triangle is opposite i + 2.
        EXPECT_NEAR(matrix(edges.ofTriangle[0][i], edges.ofTriangle[0][j]),
          4.0 * linear((i + 2) % 3, (j + 2) % 3), 1e-12 * linear.norm());
      }
    }
  }
}

/// Minimises the energy with the values of f on the boundary edges and returns the values on all
/// edges.
Eigen::VectorXd SolveDirichlet(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const SparseMatrix& stiffness, const RealFunction& f)
{
  Eigen::VectorXd u = AtMidpoints(mesh, edges, f);
  SparseMatrix matrix = stiffness;
  const std::vector<bool> boundary = OnBoundary(edges);
  for (int e = 0; e < edges.Count(); ++e)
  {
    u[e] = boundary[e] ? u[e] : 0.0;
  }
  Eigen::VectorXd load = -(stiffness * u);
  matrix.prune([&](int i, int j, double) { return i == j || (!boundary[i] && !boundary[j]); });
  for (int e = 0; e < edges.Count(); ++e)
  {
    load[e] = boundary[e] ? 0.0 : load[e];
  }
  return u + Eigen::SimplicialLDLT<SparseMatrix>(matrix).solve(load);
}

TEST(CrouzeixRaviart, EnergyAndValuesConvergeAtSecondOrder)
{
  // e^x cos y is harmonic; on the unit square ½ ∫ |∇f|² = ¼ (e² − 1).
  const RealFunction f = [](const Point& x) { return std::exp(x.x()) * std::cos(x.y()); };
  const double exact = 0.25 * (std::exp(2.0) - 1.0);
  DrillOptions options;
  options.meshSize = 0.25;
  TriangleMesh mesh = DrillHoles(Builtin("square"), {}, options);
  std::vector<double> sizes;
  std::vector<double> energyErrors;
  std::vector<double> valueErrors;
  for (int level = 0; level < 5; ++level)
  {
    const EdgeNumbering edges = NumberEdges(mesh);
    const SparseMatrix stiffness = CrouzeixRaviartStiffness(mesh, edges);
    const Eigen::VectorXd u = SolveDirichlet(mesh, edges, stiffness, f);
    if (level >= 2) // on coarser levels, the errors along the boundary and inside partly cancel
    {
      sizes.push_back(std::pow(0.5, level));
      energyErrors.push_back(std::abs(0.5 * u.dot(stiffness * u) - exact));
      valueErrors.push_back(
        (u - AtMidpoints(mesh, edges, f)).norm() / std::sqrt(static_cast<double>(edges.Count())));
    }
    mesh = Refine(mesh);
  }
  EXPECT_NEAR(ConvergenceRate(sizes, energyErrors), 2.0, 0.1);
  EXPECT_GE(ConvergenceRate(sizes, valueErrors), 1.85);
  EXPECT_LT(energyErrors.back(), 1e-3 * exact);
}

TEST(CrouzeixRaviart, RefusesTrianglesWithoutArea)
{
  TriangleMesh mesh = TestMesh();
  const EdgeNumbering edges = NumberEdges(mesh);
  TriangleMesh flat = mesh;
  flat.points[flat.triangles[5][0]] = flat.points[flat.triangles[5][1]];
  EXPECT_TRUE(Refuses([&] { CrouzeixRaviartStiffness(flat, edges); }, { "Triangle", "no area" }));
  std::swap(mesh.triangles[7][0], mesh.triangles[7][1]);
  EXPECT_TRUE(
    Refuses([&] { CrouzeixRaviartStiffness(mesh, edges); }, { "Triangle 7", "clockwise" }));
  TriangleMesh missing = TestMesh();
  missing.points[3].x() = std::nan("");
  EXPECT_TRUE(Refuses([&] { CrouzeixRaviartStiffness(missing, edges); }, { "Triangle" }));
}

TEST(AlignedRepresentation, IsTheFourthPowerOfTheDirection)
{
  Random random(11);
  for (int trial = 0; trial < 100; ++trial)
  {
    const double angle = random.Uniform(-Pi, Pi);
    const double length = std::exp(random.Uniform(-20.0, 20.0));
    const Point direction = length * Point(std::cos(angle), std::sin(angle));
    const Complex u = AlignedRepresentation(direction);
    EXPECT_LT(std::abs(u - std::polar(1.0, 4.0 * angle)), 1e-14);
    // A cross is invariant under a quarter turn.
    EXPECT_LT(std::abs(u - AlignedRepresentation({ -direction.y(), direction.x() })), 1e-14);
  }
}
}
}
