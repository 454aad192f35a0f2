#include "ConjugateField.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "P1Laplacian.h"
#include "PotentialSolver.h"
#include "Support.h"

#include <Eigen/Cholesky>

#include <algorithm>

namespace crossfield::test
{
namespace
{
constexpr auto Islands = PotentialSolver::Periods::Islands;
constexpr auto Everywhere = PotentialSolver::Periods::IslandsAndHoles;

/// A mesh with its solver: two holes, and two islands unless it is said otherwise.
struct Prepared
{
  PotentialSolver solver;
  const TriangleMesh& mesh;
  const EdgeNumbering& edges;
  const std::vector<BoundaryLoop>& loops;

  explicit Prepared(const PlanarDomain& domain,
    PotentialSolver::Boundary boundary = PotentialSolver::Boundary::Natural)
    : solver(ShareTopology(MakeMesh(domain)), boundary)
    , mesh(solver.GetTopology().mesh)
    , edges(solver.GetTopology().edges)
    , loops(solver.GetTopology().loops)
  {
  }
  static TriangleMesh MakeMesh(const PlanarDomain& domain)
  {
    DrillOptions options;
    options.meshSize = 0.15;
    options.minimumHoleEdges = 12;
    return DrillHoles(domain, { { { 0.0, 0.55 }, 1, 0.1 }, { { 0.1, -0.5 }, -1, 0.08 } }, options);
  }
};

PlanarDomain Plain()
{
  return MakePlanarDomain({ RegularPolygon(40) });
}

PlanarDomain WithIslands()
{
  return MakePlanarDomain({ RegularPolygon(40), RegularPolygon(4, 0.2, Point(0.4, 0.1)),
    RegularPolygon(9, 0.15, Point(-0.4, 0.1)) });
}

/// Random sources with sum zero over the vertices, and random periods.
Eigen::VectorXd RandomSources(Random& random, const Prepared& prepared)
{
  Eigen::VectorXd sources =
    Eigen::VectorXd::NullaryExpr(prepared.solver.Rows(), [&] { return random.Uniform(-1.0, 1.0); });
  auto atVertices = sources.head(static_cast<Eigen::Index>(prepared.mesh.points.size()));
  atVertices.array() -= atVertices.mean();
  return sources;
}

TEST(PotentialSolver, SolvesTheLaplacianForAnySourcesOfSumZero)
{
  Random random(110);
  const Prepared prepared(Plain());
  ASSERT_EQ(prepared.solver.PeriodCount(Islands), 0);
  const SparseMatrix stiffness = P1Stiffness(prepared.mesh, prepared.edges);
  for (int trial = 0; trial < 5; ++trial)
  {
    const Eigen::VectorXd sources = RandomSources(random, prepared);
    const Eigen::VectorXd solution = prepared.solver.Solve(sources, Islands);
    EXPECT_EQ(solution.tail(2).norm(), 0.0) << "periods around holes";
    const Eigen::Index vertices = stiffness.rows();
    EXPECT_LE(
      (stiffness * solution.head(vertices) - sources.head(vertices)).lpNorm<Eigen::Infinity>(),
      1e-11);
  }
}

TEST(PotentialSolver, EnergyOfTheSolutionIsHalfItsWork)
{
  // ½ ∫ |∇Ψ + Σ q_k ∇η_k|² is the quadratic form of the matrix, and so ½ bᵀ x where A x = b.
  Random random(111);
  const Prepared prepared(WithIslands());
  ASSERT_EQ(prepared.solver.PeriodCount(), 4);
  for (int trial = 0; trial < 5; ++trial)
  {
    const Eigen::VectorXd sources = RandomSources(random, prepared);
    const Eigen::VectorXd solution = prepared.solver.Solve(sources, Everywhere);
    const double energy = GradientEnergy(prepared.mesh, prepared.solver.Gradient(solution));
    EXPECT_NEAR(energy, 0.5 * sources.dot(solution), 1e-10 * energy);
  }
}

TEST(PotentialSolver, ApplyGivesBackTheSources)
{
  Random random(113);
  const Prepared prepared(WithIslands());
  const Eigen::VectorXd sources = RandomSources(random, prepared);
  const Eigen::VectorXd applied = prepared.solver.Apply(prepared.solver.Solve(sources, Everywhere));
  EXPECT_LE((applied - sources).lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(PotentialSolver, AGivenBoundaryKeepsItsValuesAndPeriods)
{
  Random random(114);
  const Prepared prepared(WithIslands(), PotentialSolver::Boundary::Given);
  const PotentialSolver& solver = prepared.solver;
  const auto isGiven = [&](Eigen::Index row)
  {
    return row >= solver.PeriodRow(0) ||
      std::any_of(prepared.mesh.boundary.begin(), prepared.mesh.boundary.end(),
        [row](const BoundaryEdge& edge)
        { return edge.kind != BoundaryKind::Hole && edge.vertices[0] == row; });
  };
  Eigen::VectorXd given = Eigen::VectorXd::Zero(solver.Rows());
  for (Eigen::Index row = 0; row < given.size(); ++row)
  {
    given[row] = isGiven(row) ? random.Uniform(-1.0, 1.0) : 0.0;
  }
  const Eigen::VectorXd solution = given + solver.Solve(-solver.Apply(given), Everywhere);
  const Eigen::VectorXd sources = solver.Apply(solution);
  for (Eigen::Index row = 0; row < given.size(); ++row)
  {
    if (isGiven(row))
    {
      EXPECT_EQ(solution[row], given[row]);
    }
    else
    {
      EXPECT_NEAR(sources[row], 0.0, 1e-11);
    }
  }
  EXPECT_EQ(solver.PeriodFactor(Everywhere).size(), 0);
}

TEST(PotentialSolver, GradientOfALinearPotentialIsItsSlope)
{
  const Prepared prepared(WithIslands());
  const Point slope(1.5, -0.25);
  Eigen::VectorXd solution = Eigen::VectorXd::Zero(prepared.solver.Rows());
  for (std::size_t v = 0; v < prepared.mesh.points.size(); ++v)
  {
    solution[v] = slope.dot(prepared.mesh.points[v]);
  }
  const Eigen::Matrix2Xd gradient = prepared.solver.Gradient(solution);
  for (const auto column : gradient.colwise())
  {
    ASSERT_LE((column - slope).norm(), 1e-12);
  }
}

TEST(PotentialSolver, TheConjugateHasTheJumpsThatTheSourcesPrescribe)
{
  // docs/method.md §2: sources at the vertices of boundary loops and periods, none inside and none in sum
  // around any loop, give a single-valued φ; its differences are the right-hand side.
  Random random(112);
  const Prepared prepared(WithIslands());
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(prepared.solver.Rows());
  for (const BoundaryLoop& loop : prepared.loops)
  {
    const std::vector<int> vertices = WalkedVertices(prepared.mesh, loop);
    for (std::size_t i = 0; i < vertices.size(); ++i)
    {
      const double jump = random.Uniform(-1.0, 1.0);
      sources[vertices[i]] += jump;
      sources[vertices[(i + 1) % vertices.size()]] -= jump;
    }
  }
  for (Eigen::Index k = 0; k < 4; ++k)
  {
    sources[prepared.solver.PeriodRow(k)] = random.Uniform(-1.0, 1.0);
  }
  const Eigen::Matrix2Xd gradient =
    prepared.solver.Gradient(prepared.solver.Solve(sources, Everywhere));
  const Eigen::VectorXd phase = IntegrateConjugate(prepared.mesh, prepared.edges, gradient,
    prepared.edges.ofBoundary[0], Eigen::VectorXd::Constant(1, 0.7))
                                  .transpose();
  EXPECT_EQ(phase[prepared.edges.ofBoundary[0]], 0.7);

  std::vector<int> ending(prepared.mesh.points.size(), -1);
  for (std::size_t i = 0; i < prepared.mesh.boundary.size(); ++i)
  {
    ending[prepared.mesh.boundary[i].vertices[1]] = prepared.edges.ofBoundary[i];
  }
  for (std::size_t i = 0; i < prepared.mesh.boundary.size(); ++i)
  {
    const int vertex = prepared.mesh.boundary[i].vertices[0];
    EXPECT_NEAR(
      phase[prepared.edges.ofBoundary[i]] - phase[ending[vertex]], sources[vertex], 1e-10);
  }
  for (Eigen::Index k = 0; k < 4; ++k)
  {
    const auto& strip = prepared.solver.GetStrips()[k];
    EXPECT_NEAR(phase[prepared.edges.ofBoundary[strip.firstBoundaryEdge]] -
        phase[prepared.edges.ofBoundary[strip.lastBoundaryEdge]],
      sources[prepared.solver.PeriodRow(k)], 1e-10);
  }
  // Discrete conjugacy: φ has the same energy in the other space, and is harmonic inside.
  const SparseMatrix stiffness = CrouzeixRaviartStiffness(prepared.mesh, prepared.edges);
  Eigen::VectorXd residual = stiffness * phase;
  const double energy = GradientEnergy(prepared.mesh, gradient);
  EXPECT_NEAR(0.5 * phase.dot(residual), energy, 1e-10 * energy);
  for (int edge : prepared.edges.ofBoundary)
  {
    residual[edge] = 0.0;
  }
  EXPECT_LE(residual.lpNorm<Eigen::Infinity>(), 1e-10);
}

TEST(PotentialSolver, PeriodFactorBelongsToTheSchurComplement)
{
  // Unit sources at the periods: the inverse of the Schur complement is what they do there.
  const Prepared prepared(WithIslands());
  for (const auto periods : { Islands, Everywhere })
  {
    const Eigen::Index count = prepared.solver.PeriodCount(periods);
    EXPECT_EQ(count, periods == Islands ? 2 : 4);
    Eigen::MatrixXd sources = Eigen::MatrixXd::Zero(prepared.solver.Rows(), count);
    sources.middleRows(prepared.solver.PeriodRow(0), count).setIdentity();
    const Eigen::MatrixXd inverse =
      prepared.solver.Solve(sources, periods).middleRows(prepared.solver.PeriodRow(0), count);
    const Eigen::MatrixXd lower = prepared.solver.PeriodFactor(periods);
    const Eigen::MatrixXd identity = lower * (lower.transpose() * inverse);
    EXPECT_LE((identity - Eigen::MatrixXd::Identity(count, count)).norm(), 1e-10);
  }
}

TEST(PotentialSolver, HoleSourcesAreTheDifferencesAroundHoles)
{
  const Prepared prepared(WithIslands());
  const Eigen::SparseMatrix<double>& sources = prepared.solver.HoleSources();
  Eigen::Index column = 0;
  Eigen::Index period = 2;
  for (const BoundaryLoop& loop : prepared.loops)
  {
    const auto size = static_cast<Eigen::Index>(loop.edges.size());
    Eigen::Index last = 0;
    for (Eigen::Index j = 0; loop.kind == BoundaryKind::Hole && j < size; ++j)
    {
      // Vertex j joins edges j and j + 1.
      const auto& edge = prepared.mesh.boundary[loop.edges[j]].vertices;
      EXPECT_EQ(edge[0], prepared.mesh.boundary[loop.edges[(j + 1) % size]].vertices[1]);
      EXPECT_EQ(sources.coeff(edge[0], column + j), 1.0);
      EXPECT_EQ(sources.coeff(edge[0], column + (j + 1) % size), -1.0);
      last += sources.coeff(prepared.solver.PeriodRow(period), column + j) == -1.0 ? 1 : 0;
    }
    if (loop.kind == BoundaryKind::Hole)
    {
      EXPECT_EQ(last, 1);
      column += size;
      ++period;
    }
  }
  EXPECT_EQ(sources.cols(), column);
  EXPECT_EQ(sources.nonZeros(), 2 * column + 2);
}

TEST(PotentialSolver, HoleResponseIsWhatSourcesOnHolesDo)
{
  for (const auto boundary :
    { PotentialSolver::Boundary::Natural, PotentialSolver::Boundary::Given })
  {
    for (const PlanarDomain& domain : { Plain(), WithIslands() })
    {
      for (const auto periods : { Islands, Everywhere })
      {
        const Prepared prepared(domain, boundary);
        const PotentialSolver& solver = prepared.solver;
        const Eigen::MatrixXd sources = solver.HoleSources();
        Eigen::MatrixXd expected = sources.transpose() * solver.Solve(sources, periods);
        const PotentialSolver::HoleResponse& response = solver.GetHoleResponse(periods);
        ASSERT_EQ(response.elastic.BlockCount(), 2);
        if (periods == Islands || boundary == PotentialSolver::Boundary::Given)
        {
          const double mean = expected.diagonal().mean();
          expected.topLeftCorner(12, 12).array() += mean / 12.0;
          expected.bottomRightCorner(12, 12).array() += mean / 12.0;
        }
        EXPECT_LE((response.elastic.Dense() - expected).norm(), 1e-11 * expected.norm());

        Eigen::MatrixXd atPeriods = Eigen::MatrixXd::Zero(solver.Rows(),
          boundary == PotentialSolver::Boundary::Natural ? solver.PeriodCount(periods) : 0);
        atPeriods.middleRows(solver.PeriodRow(0), atPeriods.cols()).setIdentity();
        ASSERT_EQ(response.periods.cols(), atPeriods.cols());
        if (atPeriods.cols() == 0)
        {
          continue;
        }
        EXPECT_LE(
          (response.periods - sources.transpose() * solver.Solve(atPeriods, periods)).norm(),
          1e-11);
      }
    }
  }
}

TEST(PotentialSolver, RefusesSourcesWithASum)
{
  const Prepared prepared(Plain());
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(prepared.solver.Rows());
  sources[3] = 0.5;
  EXPECT_TRUE(Refuses(
    [&] { prepared.solver.Solve(sources, Islands); }, { "add up to 0.5", "Poincaré-Hopf" }));
}
}
}
