#include "DirectPerforatedSolve.h"
#include "DrillHoles.h"
#include "PotentialReduction.h"
#include "ReducedProblem.h"
#include "Support.h"
#include "UnitNormField.h"
#include "UnitSolve.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace crossfield::test
{
namespace
{
/// Returns a problem with three edges per hole, a random positive semidefinite matrix, and a load
/// of random magnitude.
ReducedProblem RandomProblem(Random& random, int holeCount)
{
  constexpr int Edges = 3;
  ReducedProblem problem;
  for (int h = 0; h < holeCount; ++h)
  {
    DegreeConstraint constraint;
    for (int j = 0; j < Edges; ++j)
    {
      constraint.unknowns.push_back(Edges * h + j);
      constraint.turning.push_back(random.UnitComplex());
    }
    problem.constraints.push_back(constraint);
  }
  const int size = Edges * holeCount;
  const Eigen::MatrixXd root = RandomMatrix(random, size, size);
  problem.matrix = MatrixOn(problem.constraints, root * root.transpose());
  const double scale = std::pow(10.0, random.Uniform(-2.0, 1.0));
  problem.load = ComplexVector::NullaryExpr(size, [&] { return scale * random.Square(); });
  return problem;
}

/// The problem in the factors of the holes, written out independently.
struct Torus
{
  Eigen::MatrixXcd matrix;
  ComplexVector load;

  explicit Torus(const ReducedProblem& problem)
  {
    const auto holes = static_cast<Eigen::Index>(problem.constraints.size());
    const Eigen::MatrixXd dense = problem.matrix.Dense();
    this->matrix = Eigen::MatrixXcd::Zero(holes, holes);
    this->load = ComplexVector::Zero(holes);
    for (Eigen::Index a = 0; a < holes; ++a)
    {
      const DegreeConstraint& row = problem.constraints[static_cast<std::size_t>(a)];
      for (std::size_t i = 0; i < row.unknowns.size(); ++i)
      {
        this->load[a] += std::conj(row.turning[i]) * problem.load[row.unknowns[i]];
        for (Eigen::Index b = 0; b < holes; ++b)
        {
          const DegreeConstraint& column = problem.constraints[static_cast<std::size_t>(b)];
          for (std::size_t j = 0; j < column.unknowns.size(); ++j)
          {
            this->matrix(a, b) += std::conj(row.turning[i]) *
              dense(row.unknowns[i], column.unknowns[j]) * column.turning[j];
          }
        }
      }
    }
  }

  double Value(const ComplexVector& a) const
  {
    return 0.5 * a.dot(this->matrix * a).real() - this->load.dot(a).real();
  }

  /// Sets each phase in turn to its best value until no phase changes.
  double Refine(ComplexVector a) const
  {
    double moved = 1.0;
    for (int sweep = 0; sweep < 5000 && moved > 1e-8; ++sweep)
    {
      moved = 0.0;
      for (Eigen::Index i = 0; i < a.size(); ++i)
      {
        const Complex pull =
          this->load[i] - (this->matrix.row(i) * a).value() + this->matrix(i, i) * a[i];
        const Complex best = pull / std::abs(pull);
        moved = std::max(moved, std::abs(best - a[i]));
        a[i] = best;
      }
    }
    return this->Value(a);
  }

  /// Returns the lowest value reached from the best points of a grid over all phases.
  double Lowest() const
  {
    const Eigen::Index holes = this->load.size();
    const int steps = holes == 2 ? 48 : holes == 3 ? 20 : 12;
    const auto point = [&](int number)
    {
      ComplexVector a(holes);
      for (Complex& factor : a)
      {
        factor = std::polar(1.0, 2.0 * Pi * (number % steps) / steps);
        number /= steps;
      }
      return a;
    };
    std::vector<std::pair<double, int>> grid;
    for (int i = 0; i < static_cast<int>(std::pow(steps, holes) + 0.5); ++i)
    {
      grid.emplace_back(this->Value(point(i)), i);
    }
    constexpr int Refined = 30;
    std::partial_sort(grid.begin(), grid.begin() + Refined, grid.end());
    double lowest = std::numeric_limits<double>::infinity();
    for (int i = 0; i < Refined; ++i)
    {
      lowest = std::min(lowest, this->Refine(point(grid[static_cast<std::size_t>(i)].second)));
    }
    return lowest;
  }
};

TEST(UnitSolve, FindsTheLowestPhases)
{
  constexpr int Trials = 150;
  for (int trial = 0; trial < Trials; ++trial)
  {
    SCOPED_TRACE(trial);
    Random random(static_cast<std::uint32_t>(20000 + trial));
    const ReducedProblem problem = RandomProblem(random, 2 + trial % 3);
    const ComplexVector start =
      ComplexVector::NullaryExpr(problem.load.size(), [&] { return random.UnitComplex(); });
    const MinimiserResult found = SolveReducedUnit(problem, start);
    EXPECT_TRUE(found.converged);
    const double value =
      0.5 * found.x.dot(problem.matrix * found.x).real() - problem.load.dot(found.x).real();
    const double lowest = Torus(problem).Lowest();
    EXPECT_LE(value, lowest + 1e-9 * (1.0 + std::abs(lowest)));
  }
}

/// Returns four holes in the disk with sum 4, one of opposite sign in every second trial, at a
/// distance from each other and from the circle.
Configuration RandomHoles(Random& random, int trial)
{
  const std::array<int, 4> quarters =
    trial % 2 == 0 ? std::array<int, 4>{ 1, 1, 1, 1 } : std::array<int, 4>{ 3, 1, -1, 1 };
  Configuration holes;
  for (const int quarter : quarters)
  {
    const double radius = random.Uniform(0.08, 0.2);
    Point place;
    do
    {
      const Complex z = random.Uniform(0.0, 0.95 - radius) * random.UnitComplex();
      place = Point(z.real(), z.imag());
    } while (std::any_of(holes.begin(), holes.end(),
      [&](const Singularity& other)
      { return (other.position - place).norm() < other.radius + radius + 0.05; }));
    holes.push_back({ place, quarter, radius });
  }
  return holes;
}

TEST(UnitSolve, SixtyStartsFindNoBetterPhasesOnHolesOfADisk)
{
  constexpr int Starts = 60;
  for (int trial = 0; trial < 30; ++trial)
  {
    SCOPED_TRACE(trial);
    Random random(static_cast<std::uint32_t>(700 + trial));
    DrillOptions options;
    options.meshSize = 0.2;
    const TriangleMesh mesh = DrillHoles(Builtin("disk", 0.2), RandomHoles(random, trial), options);
    const PotentialProblem onMesh = ProblemOn(mesh);
    const PotentialReduction reduction(onMesh, PotentialSolver::Periods::IslandsAndHoles);
    const ReducedProblem& problem = reduction.GetReducedProblem();
    const MinimiserResult found =
      SolveReducedUnit(problem, reduction.ValuesOf(SolveUnitNorm(onMesh).u));
    EXPECT_TRUE(found.converged);
    const double value =
      0.5 * found.x.dot(problem.matrix * found.x).real() - problem.load.dot(found.x).real();
    const Torus torus(problem);
    double lowest = std::numeric_limits<double>::infinity();
    for (int start = 0; start < Starts; ++start)
    {
      lowest = std::min(lowest,
        torus.Refine(
          ComplexVector::NullaryExpr(torus.load.size(), [&] { return random.UnitComplex(); })));
    }
    EXPECT_LE(value, lowest + 1e-7 * (1.0 + std::abs(lowest)));
  }
}

TEST(UnitSolve, CrossesAreUnitAndTurnEvenly)
{
  // Many holes, for which a restart is only tried where a sweep promises an improvement.
  for (const int holes : { 1, 5, 20, 40 })
  {
    SCOPED_TRACE(holes);
    Random random(static_cast<std::uint32_t>(31 + holes));
    const ReducedProblem problem = RandomProblem(random, holes);
    const ComplexVector start =
      ComplexVector::NullaryExpr(problem.load.size(), [&] { return random.UnitComplex(); });
    const MinimiserResult found = SolveReducedUnit(problem, start);
    EXPECT_TRUE(found.converged);
    for (const DegreeConstraint& constraint : problem.constraints)
    {
      const Complex factor = found.x[constraint.unknowns[0]] / constraint.turning[0];
      EXPECT_NEAR(std::abs(factor), 1.0, 1e-12);
      for (std::size_t j = 0; j < constraint.unknowns.size(); ++j)
      {
        EXPECT_LT(
          std::abs(found.x[constraint.unknowns[j]] - factor * constraint.turning[j]), 1e-12);
      }
    }
  }
}

TEST(UnitSolve, RelaxedPhasesAreALocalMinimum)
{
  for (int trial = 0; trial < 20; ++trial)
  {
    SCOPED_TRACE(trial);
    Random random(static_cast<std::uint32_t>(500 + trial));
    const ReducedProblem problem = RandomProblem(random, 1 + trial);
    const ComplexVector start =
      ComplexVector::NullaryExpr(problem.load.size(), [&] { return random.Square(); });
    const auto value = [&](const ComplexVector& x)
    { return 0.5 * x.dot(problem.matrix * x).real() - problem.load.dot(x).real(); };
    const ComplexVector relaxed = RelaxPhases(problem, start);
    const double lowest = value(relaxed);
    EXPECT_LE(lowest, value(start));
    for (const DegreeConstraint& constraint : problem.constraints)
    {
      ComplexVector turned = relaxed;
      const Complex factor = relaxed[constraint.unknowns[0]] / start[constraint.unknowns[0]];
      EXPECT_NEAR(std::abs(factor), 1.0, 1e-12);
      for (const int unknown : constraint.unknowns)
      {
        EXPECT_LT(std::abs(relaxed[unknown] - factor * start[unknown]), 1e-12);
        turned[unknown] *= std::polar(1.0, 1e-3);
      }
      EXPECT_GE(value(turned), lowest - 1e-12 * (1.0 + std::abs(lowest)));
    }
  }
}

/// Without a load all holes may turn together, and all such fields are equivalent.
TEST(UnitSolve, SolvesUpToACommonRotationWithoutALoad)
{
  Random random(321);
  for (const int holes : { 1, 2, 5 })
  {
    SCOPED_TRACE(holes);
    ReducedProblem problem = RandomProblem(random, holes);
    problem.load.setZero();
    const ComplexVector start = ComplexVector::Ones(problem.load.size());
    const MinimiserResult solution = SolveReducedUnit(problem, start);
    EXPECT_TRUE(solution.converged);
    EXPECT_NEAR(solution.x.cwiseAbs().maxCoeff(), 1.0, 1e-12);
    EXPECT_NEAR(solution.x.cwiseAbs().minCoeff(), 1.0, 1e-12);
    EXPECT_TRUE(RelaxPhases(problem, solution.x).allFinite());
  }
}
}
}
