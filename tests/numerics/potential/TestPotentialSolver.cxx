#include "ConjugateField.h"
#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "P1Laplacian.h"
#include "PotentialSolver.h"
#include "Support.h"

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>
#include <atomic>
#include <functional>
#include <thread>

namespace crossfield::test
{
namespace
{
constexpr auto Islands = PotentialSolver::Periods::Islands;
constexpr auto Everywhere = PotentialSolver::Periods::IslandsAndHoles;

/// A mesh with two holes, and its solver.
struct Prepared
{
  PotentialSolver solver;
  const TriangleMesh& mesh;
  const EdgeNumbering& edges;
  const std::vector<BoundaryLoop>& loops;

  explicit Prepared(const PlanarDomain& domain)
    : solver(ShareTopology(MakeMesh(domain)))
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

PlanarDomain WithoutIslands()
{
  return MakePlanarDomain({ RegularPolygon(40) });
}

/// Returns the same domain with two islands.
PlanarDomain WithIslands()
{
  return MakePlanarDomain({ RegularPolygon(40), RegularPolygon(4, 0.2, Point(0.4, 0.1)),
    RegularPolygon(9, 0.15, Point(-0.4, 0.1)) });
}

/// Returns random sources with sum zero over the vertices, and random sources at periods.
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
  const Prepared prepared(WithoutIslands());
  ASSERT_EQ(prepared.solver.PeriodCount(Islands), 0);
  const SparseMatrix stiffness = P1Stiffness(prepared.solver.GetTopology());
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

TEST(PotentialSolver, EnergyOfTheSolutionIsHalfTheWorkOfTheSources)
{
  // ½ ∫ |∇Ψ + Σ q_k ∇η_k|² is the quadratic form of the matrix, and so ½ bᵀ x where A x = b.
  Random random(111);
  const Prepared prepared(WithIslands());
  ASSERT_EQ(prepared.solver.PeriodCount(), 4);
  for (int trial = 0; trial < 5; ++trial)
  {
    const Eigen::VectorXd sources = RandomSources(random, prepared);
    const Eigen::VectorXd solution = prepared.solver.Solve(sources, Everywhere);
    const double energy =
      GradientEnergy(prepared.solver.GetTopology(), prepared.solver.Gradient(solution));
    EXPECT_NEAR(energy, 0.5 * sources.dot(solution), 1e-10 * energy);
  }
}

TEST(PotentialSolver, ApplyReturnsTheSourcesOfASolution)
{
  Random random(113);
  const Prepared prepared(WithIslands());
  const Eigen::VectorXd sources = RandomSources(random, prepared);
  const Eigen::VectorXd applied =
    prepared.solver.GetOperator().Apply(prepared.solver.Solve(sources, Everywhere));
  EXPECT_LE((applied - sources).lpNorm<Eigen::Infinity>(), 1e-11);
}

TEST(DirichletSolver, KeepsPrescribedValuesAndPeriodsAndIsHarmonicInside)
{
  Random random(114);
  const Prepared prepared(WithIslands());
  const PotentialOperator& laplacian = prepared.solver.GetOperator();
  const DirichletSolver& dirichlet = prepared.solver.GetDirichlet();
  const auto isPrescribed = [&](Eigen::Index row)
  {
    return row >= laplacian.PeriodRow(0) ||
      std::any_of(prepared.mesh.boundary.begin(), prepared.mesh.boundary.end(),
        [row](const BoundaryEdge& edge)
        { return edge.kind != BoundaryKind::Hole && edge.vertices[0] == row; });
  };
  Eigen::VectorXd prescribed = Eigen::VectorXd::Zero(laplacian.Rows());
  for (Eigen::Index row = 0; row < prescribed.size(); ++row)
  {
    prescribed[row] = isPrescribed(row) ? random.Uniform(-1.0, 1.0) : 0.0;
  }
  const Eigen::VectorXd solution = dirichlet.Harmonic(prescribed);
  const Eigen::VectorXd sources = laplacian.Apply(solution);
  EXPECT_LT((dirichlet.HarmonicSources(prescribed) - sources).norm(), 1e-12 * sources.norm());
  for (Eigen::Index row = 0; row < prescribed.size(); ++row)
  {
    if (isPrescribed(row))
    {
      EXPECT_EQ(solution[row], prescribed[row]);
    }
    else
    {
      EXPECT_NEAR(sources[row], 0.0, 1e-11);
    }
  }
  EXPECT_EQ(dirichlet.GetFactor().PeriodFactor(Everywhere).size(), 0);
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

TEST(PotentialSolver, ConjugateHasTheJumpsPrescribedBySources)
{
  // docs/method.md §2: sources at the vertices of boundary loops and periods, none inside and none
  // in sum around any loop, give a single-valued φ; its differences are the right-hand side.
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
  const Eigen::VectorXd phase = IntegrateConjugate(prepared.solver.GetTopology(), gradient,
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
    const Cycle& cycle = prepared.solver.GetTopology().cycles[k];
    EXPECT_NEAR(phase[prepared.edges.ofBoundary[cycle.firstBoundaryEdge]] -
        phase[prepared.edges.ofBoundary[cycle.lastBoundaryEdge]],
      sources[prepared.solver.PeriodRow(k)], 1e-10);
  }
  // Discrete conjugacy: φ has the same energy in the other space, and is harmonic inside.
  const SparseMatrix stiffness = CrouzeixRaviartStiffness(prepared.mesh, prepared.edges);
  Eigen::VectorXd residual = stiffness * phase;
  const double energy = GradientEnergy(prepared.solver.GetTopology(), gradient);
  EXPECT_NEAR(0.5 * phase.dot(residual), energy, 1e-10 * energy);
  for (int edge : prepared.edges.ofBoundary)
  {
    residual[edge] = 0.0;
  }
  EXPECT_LE(residual.lpNorm<Eigen::Infinity>(), 1e-10);
}

TEST(PotentialSolver, PeriodFactorIsThatOfTheSchurComplement)
{
  // The solutions at the periods for unit sources there are the inverse of the Schur complement.
  const Prepared prepared(WithIslands());
  for (const auto periods : { Islands, Everywhere })
  {
    const Eigen::Index count = prepared.solver.PeriodCount(periods);
    EXPECT_EQ(count, periods == Islands ? 2 : 4);
    Eigen::MatrixXd sources = Eigen::MatrixXd::Zero(prepared.solver.Rows(), count);
    sources.middleRows(prepared.solver.PeriodRow(0), count).setIdentity();
    const Eigen::MatrixXd inverse =
      prepared.solver.Solve(sources, periods).middleRows(prepared.solver.PeriodRow(0), count);
    const Eigen::MatrixXd lower = prepared.solver.GetFactor().PeriodFactor(periods);
    const Eigen::MatrixXd identity = lower * (lower.transpose() * inverse);
    EXPECT_LE((identity - Eigen::MatrixXd::Identity(count, count)).norm(), 1e-10);
  }
}

TEST(PotentialSolver, HoleSourcesAreTheDifferencesAroundHoles)
{
  const Prepared prepared(WithIslands());
  const Eigen::SparseMatrix<double> sources = HoleSources(prepared.solver.GetOperator());
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

TEST(HoleResponse, AgreesWithSolutionsForSourcesOnHolesAndAtPeriods)
{
  for (const PlanarDomain& domain : { WithoutIslands(), WithIslands() })
  {
    const Prepared prepared(domain);
    const PotentialSolver& solver = prepared.solver;
    const Eigen::MatrixXd sources = HoleSources(solver.GetOperator());
    for (const PotentialFactor* factor :
      { &solver.GetFactor(), &solver.GetDirichlet().GetFactor() })
    {
      const bool natural = factor == &solver.GetFactor();
      const HoleElimination holes(*factor);
      for (const auto periods : { Islands, Everywhere })
      {
        Eigen::MatrixXd expected = sources.transpose() * factor->Solve(sources, periods);
        const HoleResponse response(holes, periods);
        ASSERT_EQ(response.elastic.BlockCount(), 2);
        if (periods == Islands || !natural)
        {
          const double mean = expected.diagonal().mean();
          expected.topLeftCorner(12, 12).array() += mean / 12.0;
          expected.bottomRightCorner(12, 12).array() += mean / 12.0;
        }
        EXPECT_LE((response.elastic.Dense() - expected).norm(), 1e-11 * expected.norm());
        if (natural)
        {
          EXPECT_EQ(solver.GetHoleResponse(periods).elastic.Dense(), response.elastic.Dense());
        }

        Eigen::MatrixXd atPeriods =
          Eigen::MatrixXd::Zero(solver.Rows(), natural ? solver.PeriodCount(periods) : 0);
        atPeriods.middleRows(solver.PeriodRow(0), atPeriods.cols()).setIdentity();
        ASSERT_EQ(response.periods.cols(), atPeriods.cols());
        if (atPeriods.cols() == 0)
        {
          continue;
        }
        EXPECT_LE(
          (response.periods - sources.transpose() * factor->Solve(atPeriods, periods)).norm(),
          1e-11);
      }
    }
  }
}

/// Returns all that a solver computes for one right-hand side, its lazy parts included.
std::vector<Eigen::MatrixXd> AnswersOf(
  const PotentialSolver& solver, const Eigen::VectorXd& sources)
{
  std::vector<Eigen::MatrixXd> answers;
  for (const auto periods : { Everywhere, Islands })
  {
    const HoleResponse& response = solver.GetHoleResponse(periods);
    answers.push_back(response.elastic.Dense());
    answers.push_back(response.periods);
    PotentialFactor::Eliminated eliminated = solver.GetFactor().Eliminate(sources, periods);
    const Eigen::MatrixXd differences = solver.GetHoles().Differences(eliminated);
    solver.GetHoles().AddSources(eliminated, differences, periods);
    answers.push_back(solver.GetFactor().PeriodValues(eliminated, periods));
    answers.push_back(solver.GetFactor().Substitute(eliminated));
    answers.push_back(solver.Solve(sources, periods));
    answers.push_back(solver.Gradient(answers.back()));
    answers.push_back(solver.GetOperator().Apply(answers[answers.size() - 2]));
  }
  const DirichletSolver& dirichlet = solver.GetDirichlet();
  Eigen::VectorXd onLoops = Eigen::VectorXd::Zero(solver.Rows());
  for (const BoundaryEdge& edge : solver.GetTopology().mesh.boundary)
  {
    onLoops[edge.vertices[0]] = edge.IsAligned() ? sources[edge.vertices[0]] : 0.0;
  }
  answers.push_back(dirichlet.HarmonicSources(onLoops));
  answers.push_back(dirichlet.IslandSources());
  return answers;
}

TEST(PotentialSolver, AnswersTwoThreadsAtOnceAsOne)
{
  Random random(115);
  constexpr std::size_t Count = 8;
  for (int trial = 0; trial < 5; ++trial)
  {
    const Prepared prepared(WithIslands());
    std::vector<Eigen::VectorXd> sources;
    std::vector<std::vector<Eigen::MatrixXd>> expected;
    for (std::size_t i = 0; i < Count; ++i)
    {
      sources.push_back(RandomSources(random, prepared));
      expected.push_back(AnswersOf(prepared.solver, sources.back()));
    }
    // None of the lazy parts of this solver exists yet.
    const PotentialSolver shared(prepared.solver.ShareTopology());
    std::array<std::vector<std::vector<Eigen::MatrixXd>>, 2> answers;
    std::atomic<int> ready = 0;
    const auto run = [&](std::vector<std::vector<Eigen::MatrixXd>>& own)
    {
      ++ready;
      while (ready < 2)
      {
        std::this_thread::yield();
      }
      for (const Eigen::VectorXd& right : sources)
      {
        own.push_back(AnswersOf(shared, right));
      }
    };
    std::thread second(run, std::ref(answers[1]));
    run(answers[0]);
    second.join();
    EXPECT_EQ(answers[0], expected);
    EXPECT_EQ(answers[1], expected);
  }
}

TEST(PotentialSolver, RefusesSourcesWithASum)
{
  const Prepared prepared(WithoutIslands());
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(prepared.solver.Rows());
  sources[3] = 0.5;
  EXPECT_TRUE(Refuses(
    [&] { prepared.solver.Solve(sources, Islands); }, { "add up to 0.5", "Poincaré-Hopf" }));
}
}
}
