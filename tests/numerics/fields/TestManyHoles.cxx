#include "DirectPerforatedSolve.h"
#include "DrillHoles.h"
#include "DualSolve.h"
#include "HoleBases.h"
#include "LocalSolve.h"
#include "PerforatedSolve.h"
#include "PotentialReduction.h"
#include "Support.h"
#include "UnitNormField.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>

#include <array>
#include <cmath>

namespace crossfield::test
{
namespace
{
/// Returns a disk with twelve holes of 32 edges, eight of k = +1 around four of k = −1, some close
/// to each other.
TriangleMesh TwelveHoles()
{
  DrillOptions options;
  options.meshSize = 0.1;
  return DrillHoles(Builtin("disk", 0.1),
    Join(OnCircle(8, 0.75, 0.1, 1, 0.05), OnCircle(4, 0.3, 0.4, -1, 0.07)), options);
}

/// Returns S, as stored in the blocks, in the values on the holes.
Eigen::MatrixXd ToDense(const DualProblem& dual)
{
  const Eigen::Index size = dual.matrix.Rows();
  Eigen::MatrixXd dense(size, size);
  for (Eigen::Index column = 0; column < size; ++column)
  {
    const ComplexVector unit = ComplexVector::Unit(size, column);
    dense.col(column) = dual.InValues(dual.matrix * dual.InBases(unit)).real();
  }
  return dense;
}

TEST(ManyHoles, OmittedCouplingsAreBelowTheirBound)
{
  const PotentialProblem problem = ProblemOn(TwelveHoles());
  const PotentialReduction reduction(problem);
  const ReducedProblem& reduced = reduction.GetReducedProblem();
  const HoleBases bases(reduced);
  const double unit = reduced.matrix.Dense().diagonal().mean();
  Eigen::Index before = 0;
  for (const double tolerance : { 1.0, 1e-2, 1e-4, 1e-8, 1e-13 })
  {
    SCOPED_TRACE(tolerance);
    const DualProblem dual = bases.InBlocks(tolerance);
    const Eigen::MatrixXd difference = ToDense(dual) - reduced.matrix.Dense();
    const double norm = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(
      0.5 * (difference + difference.transpose()), Eigen::EigenvaluesOnly)
                          .eigenvalues()
                          .lpNorm<Eigen::Infinity>();
    EXPECT_LE(norm, dual.leftOut + 1e-13 * unit * static_cast<double>(reduced.matrix.Rows()));
    EXPECT_LE(dual.leftOut, tolerance * unit * std::sqrt(2.0 * 12.0));
    // More precisely, the couplings left out are between −M and M.
    const DualProblem::Margin margin = dual.MarginOfLeftOut();
    Eigen::VectorXd diagonal(dual.matrix.Rows());
    Eigen::Index row = 0;
    for (std::size_t hole = 0; hole < dual.bases.size(); ++hole)
    {
      const Eigen::Index uncoupled = dual.bases[hole].cols() - dual.matrix.coupled[hole];
      diagonal.segment(row, uncoupled).setConstant(margin.uncoupled);
      diagonal.segment(row + uncoupled, dual.matrix.coupled[hole]).setConstant(margin.coupled);
      row += dual.bases[hole].cols();
    }
    Eigen::MatrixXd inBases(difference.rows(), difference.cols());
    for (Eigen::Index column = 0; column < difference.cols(); ++column)
    {
      const ComplexVector member = dual.InValues(ComplexVector::Unit(difference.rows(), column));
      inBases.col(column) = dual.InBases((difference * member.real()).cast<Complex>()).real();
    }
    for (const double sign : { -1.0, 1.0 })
    {
      const Eigen::MatrixXd bounded =
        Eigen::MatrixXd(diagonal.asDiagonal()) + 0.5 * sign * (inBases + inBases.transpose());
      EXPECT_GE(Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(bounded, Eigen::EigenvaluesOnly)
                  .eigenvalues()[0],
        -1e-13 * unit * static_cast<double>(reduced.matrix.Rows()));
    }
    // A smaller tolerance keeps more couplings, but far from all: couplings decrease like powers of
    // the distance.
    EXPECT_GE(dual.matrix.coupling.rows(), before);
    before = dual.matrix.coupling.rows();
    EXPECT_EQ(dual.InValues(dual.InBases(reduced.load)).size(), reduced.load.size());
    EXPECT_LE((dual.InValues(dual.InBases(reduced.load)) - reduced.load).norm(),
      1e-13 * reduced.load.norm());
  }
  EXPECT_EQ(bases.InBlocks(1e3).matrix.coupling.rows(), 0);
  EXPECT_LE(bases.InBlocks(1e-4).matrix.coupling.rows(), 12 * 8);
}

/// Returns a mesh with `count` holes of 32 edges and alternating signs, in a spiral of equal areas.
TriangleMesh SpiralOfHoles(int count, double meshSize)
{
  Configuration holes;
  int missing = 4;
  for (int i = 0; i < count; ++i)
  {
    const double radius = 0.9 * std::sqrt((i + 0.5) / count);
    const double angle = i * Pi * (3.0 - std::sqrt(5.0));
    const int index = missing == count - i || i % 2 == 0 ? 1 : -1;
    missing -= index;
    holes.push_back({ radius * Point(std::cos(angle), std::sin(angle)), index, 0.01 });
  }
  DrillOptions options;
  options.meshSize = meshSize;
  return DrillHoles(Builtin("disk", meshSize), holes, options);
}

TEST(ManyHoles, MemoryIsLinearInTheHoles)
{
  std::array<double, 2> entries = {};
  for (std::size_t i = 0; i < entries.size(); ++i)
  {
    const int holes = 15 << (2 * i);
    const PotentialSolver potential(ShareTopology(SpiralOfHoles(holes, 0.02)));
    const GramMatrix& elastic =
      potential.GetHoleResponse(PotentialSolver::Periods::Islands).elastic;
    ASSERT_EQ(elastic.Rows(), 32 * holes);
    entries[i] = static_cast<double>(elastic.Entries());
  }
  // The separators above a hole grow with the square root of the mesh size, to which holes
  // contribute here. A dense matrix would have 16 times as many entries for four times as many
  // holes.
  EXPECT_LE(entries[1], 6.0 * entries[0]);
}

TEST(ManyHoles, SixtyHolesHaveTheirDegrees)
{
  const SolvedField field = SolvePerforated(ShareTopology(SpiralOfHoles(60, 0.1)));
  EXPECT_TRUE(field.converged) << field.residual;
  EXPECT_EQ(field.wrongDegrees, 0);
  EXPECT_LE(field.residual, 1e-10);
}

TEST(ManyHoles, GlobalMinimumMatchesTheDenseProblem)
{
  const PotentialProblem problem = ProblemOn(TwelveHoles());
  const PotentialReduction reduction(problem);
  const ReducedProblem& reduced = reduction.GetReducedProblem();
  const MinimiserResult solution = SolveReduced(HoleBases(reduced));
  ASSERT_TRUE(solution.converged) << solution.residual;
  // The proof of docs/method.md §3.4 with all couplings: H is positive definite, and its x
  // satisfies all constraints.
  Eigen::MatrixXcd hessian = reduced.matrix.Dense().cast<Complex>();
  for (std::size_t i = 0; i < reduced.constraints.size(); ++i)
  {
    hessian += solution.multipliers[static_cast<Eigen::Index>(i)] *
      Eigen::MatrixXcd(reduced.constraints[i].Hessian(hessian.rows()));
  }
  const Eigen::LLT<Eigen::MatrixXcd> factor(hessian);
  ASSERT_EQ(factor.info(), Eigen::Success);
  const ComplexVector x = factor.solve(reduced.load);
  for (const DegreeConstraint& constraint : reduced.constraints)
  {
    EXPECT_NEAR(constraint.Value(x), constraint.target, 1e-8);
  }
  const auto objective = [&](const ComplexVector& at)
  { return 0.5 * at.dot(reduced.matrix * at).real() - reduced.load.dot(at).real(); };
  EXPECT_NEAR(objective(solution.x), objective(x), 1e-9 * std::abs(objective(x)));
  EXPECT_LE((solution.x - x).norm(), 1e-7 * x.norm());
}

TEST(ManyHoles, FindsAKnownSolutionFromAPathWithoutAllStrongCouplings)
{
  // For any λ at which H is positive definite, any x solves the problem with b = Hx and the targets
  // computed from x.
  const PotentialProblem problem = ProblemOn(SpiralOfHoles(160, 0.1));
  const PotentialReduction reduction(problem);
  ReducedProblem known = reduction.GetReducedProblem();
  Random random(630);
  ComplexVector x(known.matrix.Rows());
  for (const DegreeConstraint& constraint : known.constraints)
  {
    for (std::size_t j = 0; j < constraint.unknowns.size(); ++j)
    {
      x[constraint.unknowns[j]] = constraint.turning[j] + 0.1 * random.Square();
    }
  }
  known.load = known.matrix * x;
  Eigen::VectorXd multipliers(static_cast<Eigen::Index>(known.constraints.size()));
  for (Eigen::Index i = 0; i < multipliers.size(); ++i)
  {
    DegreeConstraint& constraint = known.constraints[static_cast<std::size_t>(i)];
    // A single hole reaches the border at about 1/2: its S has 2π/32 where A has 2 sin(2π/32).
    multipliers[i] = random.Uniform(-0.3, 0.3);
    known.load += multipliers[i] * constraint.Gradient(x);
    constraint.target = constraint.Value(x);
  }
  const HoleBases bases(known);
  ASSERT_LT(bases.InFewBlocks(2).matrix.coupling.rows(), bases.CoupledMembers(HoleBases::Strong));
  const MinimiserResult solution = SolveReduced(bases);
  ASSERT_TRUE(solution.converged) << solution.residual;
  EXPECT_LE((solution.multipliers - multipliers).norm(), 1e-7);
  EXPECT_LE((solution.x - x).norm(), 1e-7 * x.norm());
}

TEST(ManyHoles, LocalMinimumMatchesTheDenseProblem)
{
  const PotentialProblem problem = ProblemOn(TwelveHoles());
  const PotentialReduction reduction(problem);
  const ReducedProblem& reduced = reduction.GetReducedProblem();
  const ComplexVector start = reduction.ValuesOf(SolveUnitNorm(problem).u);
  const MinimiserResult blocks = SolveReducedFrom(HoleBases(reduced), start);
  QuadraticProblem quadratic{ reduced.matrix.Dense().cast<Complex>(), reduced.load, {} };
  for (const DegreeConstraint& constraint : reduced.constraints)
  {
    quadratic.constraints.push_back(SumOfDegrees({ constraint }));
  }
  const MinimiserResult dense = SolveQuadratic(quadratic, start);
  ASSERT_TRUE(blocks.converged) << blocks.residual;
  ASSERT_TRUE(dense.converged) << dense.residual;
  EXPECT_NEAR(blocks.values.back(), dense.values.back(), 1e-9 * std::abs(dense.values.back()));
  EXPECT_LE((blocks.x - dense.x).norm(), 1e-6 * dense.x.norm());
}
}
}
