// The variants of the constrained solve, docs/method.md §3: identities and invariances.
#include "DirectReduction.h"
#include "DualSolve.h"
#include "FieldSingularities.h"
#include "GinzburgLandau.h"
#include "PenaltySolve.h"
#include "PerforatedSolve.h"
#include "PotentialReduction.h"
#include "Support.h"
#include "VariantSolve.h"

#include <algorithm>
#include <cmath>

namespace crossfield::test
{
namespace
{
TriangleMesh FourHoles(double meshSize = 0.08, DrillMode mode = DrillMode::Perforate)
{
  return DrillMesh(Builtin("disk", meshSize), OnCircle(4, 0.6, Pi / 4.0, 1, 0.1), meshSize, mode);
}

PerforatedOptions Penalty(double epsilon)
{
  PerforatedOptions options;
  options.epsilon = epsilon;
  return options;
}

/// Returns ½ uᴴ K u.
double Energy(const TriangleMesh& mesh, const SolvedField& field)
{
  const ComplexVector elastic = CrouzeixRaviartStiffness(mesh, field.topology->edges) * field.u;
  return 0.5 * field.u.dot(elastic).real();
}

/// Returns C of every constrained loop and its target.
std::vector<std::pair<double, double>> Degrees(const TriangleMesh& mesh, const SolvedField& field)
{
  std::vector<BoundaryLoop> loops = FindImprintedLoops(mesh);
  for (const BoundaryLoop& loop : FindBoundaryLoops(mesh))
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      loops.push_back(loop);
    }
  }
  std::vector<std::pair<double, double>> degrees;
  for (const BoundaryLoop& loop : loops)
  {
    double sum = 0.0;
    std::vector<Point> midpoints;
    const std::vector<int> edges = EdgesOf(loop, field.topology->edges);
    for (std::size_t j = 0; j < edges.size(); ++j)
    {
      sum += std::imag(std::conj(field.u[edges[j]]) * field.u[edges[(j + 1) % edges.size()]]);
      midpoints.push_back(Midpoint(mesh, field.topology->edges, edges[j]));
    }
    degrees.emplace_back(sum, DegreeTarget(midpoints, CentreOf(loop, mesh), loop.quarterIndex));
  }
  return degrees;
}
}

TEST(DirectReduction, AgreesWithTheReductionToVertices)
{
  // docs/method.md §2: the conjugacy is exact, so both Schur complements have the same constrained
  // minimum.
  const TriangleMesh mesh = FourHoles();
  const SolvedField reduced = SolvePerforated(ShareTopology(mesh));
  std::vector<BoundaryLoop> holes = FindBoundaryLoops(mesh);
  holes.erase(std::remove_if(holes.begin(), holes.end(),
                [](const BoundaryLoop& loop) { return loop.kind != BoundaryKind::Hole; }),
    holes.end());
  const DirectReduction reduction(PlanarTopology(mesh), holes);
  const MinimiserResult solution = SolveReduced(HoleBases(reduction.GetReducedProblem()));
  ASSERT_TRUE(solution.converged);
  const ComplexVector u = reduction.Recover(solution.x).u;
  EXPECT_LT((u - reduced.u).lpNorm<Eigen::Infinity>(), 1e-7);
  for (std::size_t i = 0; i < reduction.FreePositions().size(); ++i)
  {
    const int edge =
      reduction.GetAligned().free[static_cast<std::size_t>(reduction.FreePositions()[i])];
    EXPECT_LT(std::abs(u[edge] - solution.x[static_cast<Eigen::Index>(i)]), 1e-10);
  }
}

TEST(VariantSolve, UnitNormOnAllHolesMatchesThePerforatedSolve)
{
  const TriangleMesh mesh = FourHoles();
  PerforatedOptions all;
  all.unitHoles = true;
  PerforatedOptions rows;
  rows.unitHoleRows = { 3, 0, 2, 1 };
  const SolvedField one = SolvePerforated(ShareTopology(mesh), all);
  const SolvedField other = SolvePerforated(ShareTopology(mesh), rows);
  EXPECT_TRUE(other.converged);
  EXPECT_TRUE(other.unitHoles);
  EXPECT_NEAR(other.energy, one.energy, 1e-8 * one.energy);
  EXPECT_LT((one.u - other.u).lpNorm<Eigen::Infinity>(), 1e-6);
}

TEST(VariantSolve, EveryConstraintCostsEnergy)
{
  const TriangleMesh mesh = FourHoles();
  PerforatedOptions options;
  options.globalConstraint = true;
  const SolvedField global = SolvePerforated(ShareTopology(mesh), options);
  const SolvedField each = SolvePerforated(ShareTopology(mesh));
  options = PerforatedOptions();
  options.unitHoleRows = { 1 };
  const SolvedField oneUnit = SolvePerforated(ShareTopology(mesh), options);
  options.unitHoleRows = { 1, 2 };
  const SolvedField twoUnit = SolvePerforated(ShareTopology(mesh), options);
  EXPECT_LE(global.energy, each.energy * (1.0 + 1e-10));
  EXPECT_LT(each.energy, oneUnit.energy);
  EXPECT_LT(oneUnit.energy, twoUnit.energy);
  for (const SolvedField* field : { &global, &each, &oneUnit, &twoUnit })
  {
    EXPECT_TRUE(field->converged);
    EXPECT_EQ(field->wrongDegrees, 0);
    EXPECT_EQ(field->unwantedSingularities, 0);
    EXPECT_NEAR(field->energy, Energy(mesh, *field), 1e-10 * field->energy);
  }
  double sum = 0.0;
  for (const auto& [value, target] : Degrees(mesh, global))
  {
    sum += value - target;
  }
  EXPECT_NEAR(sum, 0.0, 1e-8);
  for (std::size_t row = 0; row < 4; ++row)
  {
    const HoleReading& hole = twoUnit.holes[row];
    const bool unit = row == 1 || row == 2;
    EXPECT_EQ(hole.minimumNorm > 1.0 - 1e-9 && hole.maximumNorm < 1.0 + 1e-9, unit) << row;
  }
}

TEST(VariantSolve, ImprintedCirclesAreConstrainedMinima)
{
  Random random(421);
  const TriangleMesh mesh = FourHoles(0.1, DrillMode::Imprint);
  const SolvedField field = SolvePerforated(ShareTopology(mesh));
  ASSERT_TRUE(field.converged);
  EXPECT_TRUE(field.degreesReached);
  EXPECT_EQ(field.unwantedSingularities, 0);
  EXPECT_EQ(field.holes.size(), 4u);
  for (const auto& [value, target] : Degrees(mesh, field))
  {
    EXPECT_NEAR(value, target, 1e-8);
  }
  const SparseMatrix stiffness = CrouzeixRaviartStiffness(mesh, field.topology->edges);
  const ComplexVector reactions = stiffness * field.u;
  std::vector<bool> held(static_cast<std::size_t>(field.topology->edges.Count()), false);
  for (const auto* numbers :
    { &field.topology->edges.ofBoundary, &field.topology->edges.ofImprinted })
  {
    for (const int edge : *numbers)
    {
      held[static_cast<std::size_t>(edge)] = true;
    }
  }
  double onCircles = 0.0;
  for (int edge = 0; edge < field.topology->edges.Count(); ++edge)
  {
    if (!held[static_cast<std::size_t>(edge)])
    {
      EXPECT_LT(std::abs(reactions[edge]), 1e-9);
    }
  }
  for (const int edge : field.topology->edges.ofImprinted)
  {
    onCircles = std::max(onCircles, std::abs(reactions[edge]));
  }
  EXPECT_GT(onCircles, 1e-3);

  // Nearby feasible fields, constructed by scaling a perturbation of each circle, have more energy.
  const DirectReduction reduction(*field.topology, FindImprintedLoops(mesh));
  const ReducedProblem& reduced = reduction.GetReducedProblem();
  for (int trial = 0; trial < 20; ++trial)
  {
    ComplexVector x(static_cast<Eigen::Index>(reduction.FreePositions().size()));
    for (std::size_t i = 0; i < reduction.FreePositions().size(); ++i)
    {
      const auto position = static_cast<std::size_t>(reduction.FreePositions()[i]);
      x[static_cast<Eigen::Index>(i)] =
        field.u[reduction.GetAligned().free[position]] + 0.01 * random.Square();
    }
    for (const DegreeConstraint& constraint : reduced.constraints)
    {
      const double ratio = std::sqrt(constraint.target / constraint.Value(x));
      for (const int unknown : constraint.unknowns)
      {
        x[unknown] *= ratio;
      }
    }
    const ComplexVector u = reduction.Recover(x).u;
    EXPECT_GT(0.5 * u.dot(ComplexVector(stiffness * u)).real(), field.energy);
  }
}

TEST(VariantSolve, PenalisedFieldsAreConstrainedMinima)
{
  const TriangleMesh mesh = FourHoles();
  const double free = SolvePerforated(ShareTopology(mesh)).energy;
  double previous = free;
  for (const double epsilon : { 100.0, 0.4, 0.1, 0.05 })
  {
    SCOPED_TRACE(epsilon);
    const SolvedField field = SolvePerforated(ShareTopology(mesh), Penalty(epsilon));
    EXPECT_TRUE(field.converged);
    EXPECT_LT(field.residual, 1e-10);
    EXPECT_TRUE(field.degreesReached);
    EXPECT_EQ(field.unwantedSingularities, 0);
    EXPECT_EQ(field.epsilon, epsilon);
    EXPECT_NEAR(field.energy, field.gradientEnergy + field.penaltyEnergy, 1e-12 * field.energy);
    EXPECT_NEAR(field.gradientEnergy, Energy(mesh, field), 1e-10 * field.energy);
    for (const auto& [value, target] : Degrees(mesh, field))
    {
      EXPECT_NEAR(value, target, 1e-8);
    }
    EXPECT_GT(field.energy, previous); // the functional grows with 1/ε
    previous = field.energy;
    if (epsilon == 100.0)
    {
      EXPECT_NEAR(field.energy, free, 1e-3 * free);
    }
    // Stationary away from the holes.
    const GinzburgLandauEnergy energy(*field.topology, epsilon);
    const Eigen::VectorXd gradient = energy.Gradient(field.u);
    std::vector<bool> onHole(static_cast<std::size_t>(field.topology->edges.Count()), false);
    for (const int edge : field.topology->edges.ofBoundary)
    {
      onHole[static_cast<std::size_t>(edge)] = true;
    }
    for (std::size_t i = 0; i < energy.FreeEdges().size(); ++i)
    {
      if (!onHole[static_cast<std::size_t>(energy.FreeEdges()[i])])
      {
        EXPECT_LT(gradient.segment<2>(2 * static_cast<Eigen::Index>(i)).norm(), 1e-7);
      }
    }
  }
}

TEST(VariantSolve, IsInvariantUnderSimilaritiesAndRenumbering)
{
  Random random(422);
  for (const DrillMode mode : { DrillMode::Perforate, DrillMode::Imprint })
  {
    const TriangleMesh mesh = FourHoles(0.12, mode);
    const PerforatedOptions options = Penalty(mode == DrillMode::Perforate ? 0.1 : 0.0);
    const SolvedField field = SolvePerforated(ShareTopology(mesh), options);
    ASSERT_TRUE(field.converged);
    for (const double scale : { 1e-6, 1e6 })
    {
      Similarity move{ 0.7, scale, scale * Point(3.0, -2.0) };
      TriangleMesh moved = mesh;
      for (Point& point : moved.points)
      {
        point = move(point);
      }
      PerforatedOptions scaled = options;
      scaled.epsilon *= scale;
      const SolvedField other = SolvePerforated(ShareTopology(moved), scaled);
      EXPECT_TRUE(other.converged);
      EXPECT_NEAR(other.energy, field.energy, 1e-7 * field.energy);
      EXPECT_EQ(other.unwantedSingularities, field.unwantedSingularities);
    }
    TriangleMesh shuffled = mesh;
    std::reverse(shuffled.triangles.begin(), shuffled.triangles.end());
    random.Shuffle(shuffled.imprinted);
    random.Shuffle(shuffled.boundary);
    const SolvedField other = SolvePerforated(ShareTopology(shuffled), options);
    EXPECT_NEAR(other.energy, field.energy, 1e-9 * field.energy);
  }
}

TEST(VariantSolve, PenaltyWithoutHolesMatchesGinzburgLandau)
{
  // Both minimise the same functional from the harmonic field.
  const TriangleMesh mesh = DrillMesh(Builtin("ring", 0.1), {}, 0.1);
  const SolvedField field = SolvePerforated(ShareTopology(mesh), Penalty(0.1));
  GinzburgLandauOptions options;
  options.epsilon = 0.1;
  const GinzburgLandauField reference = SolveGinzburgLandau(ShareTopology(mesh), options);
  EXPECT_TRUE(field.converged && reference.converged);
  EXPECT_NEAR(field.energy, reference.energy, 1e-9 * reference.energy);
  EXPECT_LT((field.u - reference.u).lpNorm<Eigen::Infinity>(), 1e-6);
  const SolvedField disk =
    SolvePerforated(ShareTopology(DrillMesh(Builtin("disk", 0.1), {}, 0.1)), Penalty(0.1));
  EXPECT_TRUE(disk.converged);
  EXPECT_EQ(disk.unwantedSingularities, 0)
    << "no positions are prescribed, and the disk requires four";
}

TEST(VariantSolve, RejectsInvalidCombinations)
{
  const TriangleMesh holes = FourHoles(0.2);
  const TriangleMesh circles = FourHoles(0.2, DrillMode::Imprint);
  PerforatedOptions unitNorm;
  unitNorm.method = PerforatedMethod::UnitNorm;
  EXPECT_TRUE(Refuses(
    [&] { SolvePerforated(ShareTopology(circles), unitNorm); }, { "needs holes", "imprinted" }));
  unitNorm.globalConstraint = true;
  EXPECT_TRUE(Refuses([&] { SolvePerforated(ShareTopology(holes), unitNorm); },
    { "belong to the constrained method" }));
  PerforatedOptions missing;
  missing.unitHoleRows = { 4 };
  EXPECT_TRUE(Refuses(
    [&] { SolvePerforated(ShareTopology(holes), missing); }, { "hole 4", "does not have" }));
  PerforatedOptions both = Penalty(0.1);
  both.unitHoles = true;
  EXPECT_TRUE(
    Refuses([&] { SolvePerforated(ShareTopology(holes), both); }, { "cannot be combined" }));
  EXPECT_TRUE(
    Refuses([&] { SolvePerforated(ShareTopology(holes), Penalty(-1.0)); }, { "must be positive" }));
  PerforatedOptions global;
  global.globalConstraint = true;
  const TriangleMesh five = DrillMesh(Builtin("disk", 0.2), OnCircle(5, 0.6, 0.0, 1, 0.1), 0.2);
  EXPECT_TRUE(Refuses([&] { SolvePerforated(ShareTopology(five), global); },
    { "add up to 5", "requires 4" }, Error::Kind::Inconsistent));
}
}
