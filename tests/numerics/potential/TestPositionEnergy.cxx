#include "PositionCurvature.h"
#include "StrengthChanges.h"

#include "DrillHoles.h"
#include "MakePlanarDomain.h"
#include "Support.h"

#include <algorithm>

namespace crossfield::test
{
namespace
{
/// Returns a disk with a square and a circular island, so that there are corners, curves and
/// periods.
PlanarDomain TwoIslands()
{
  Loop circle;
  for (int i = 0; i < 24; ++i)
  {
    circle.emplace_back(
      -0.4 + 0.15 * std::cos(2.0 * Pi * i / 24.0), 0.1 + 0.15 * std::sin(2.0 * Pi * i / 24.0));
  }
  return MakePlanarDomain({ Builtin("disk", 0.1).loops[0],
    { { 0.3, -0.1 }, { 0.5, -0.1 }, { 0.5, 0.1 }, { 0.3, 0.1 } }, circle });
}

const Configuration Singularities = { { { 0.1, 0.5 }, -1, 0.0 }, { { 0.05, -0.4 }, 2, 0.0 },
  { { -0.1, 0.3 }, 1, 0.0 }, { { 0.7, 0.2 }, -1, 0.0 }, { { -0.6, -0.3 }, -1, 0.0 } };

/// Returns the choice of a quarter index at the boundary vertex farthest to the right, and at a
/// corner of the square.
std::vector<CornerChoice> Choices(const PlanarTopology& topology, int atCurve, int atCorner)
{
  std::vector<CornerChoice> choices;
  if (atCurve != 0)
  {
    const Loop outer = topology.AlignedLoops()[0];
    choices.push_back({ *std::max_element(outer.begin(), outer.end(),
                          [](const Point& a, const Point& b) { return a.x() < b.x(); }),
      atCurve });
  }
  choices.push_back({ { 0.3, -0.1 }, atCorner });
  return choices;
}

PointPotential PotentialWith(
  const std::shared_ptr<const PotentialSolver>& solver, int atCurve, int atCorner)
{
  const PlanarTopology& topology = solver->GetTopology();
  return { solver,
    AlignWithBoundary(
      topology, Choices(topology, atCurve, atCorner), TotalQuarters(Singularities)) };
}

std::shared_ptr<const PotentialSolver> Solver()
{
  DrillOptions options;
  options.meshSize = 0.1;
  return std::make_shared<const PotentialSolver>(
    ShareTopology(DrillHoles(TwoIslands(), {}, options)));
}

void ExpectEqual(const Eigen::Matrix2Xd& actual, const Eigen::Matrix2Xd& expected)
{
  ASSERT_EQ(actual.cols(), expected.cols());
  EXPECT_LT((actual - expected).norm(), 1e-10 * (1.0 + expected.norm()));
}

TEST(PositionEnergy, IsTheRenormalizedEnergyOfEveryConfiguration)
{
  const auto potential = std::make_shared<const PointPotential>(PotentialWith(Solver(), -1, 0));
  const PositionEnergy energy(potential);
  for (const double shift : { 0.0, 0.03, -0.05 })
  {
    Configuration moved = Singularities;
    moved[0].position += Point(shift, 2.0 * shift);
    moved[3].position -= Point(shift, shift);
    const RenormalizedEnergyValue expected =
      EvaluateRenormalizedEnergy(*potential, potential->Solve(moved));
    const RenormalizedEnergyValue actual = energy.Evaluate(moved).renormalized;
    EXPECT_NEAR(actual.energy, expected.energy, 1e-10);
    EXPECT_NEAR(actual.singleValuedEnergy, expected.singleValuedEnergy, 1e-10);
    EXPECT_NEAR(actual.logarithmCoefficient, expected.logarithmCoefficient, 1e-12);
    ExpectEqual(actual.gradient, expected.gradient);
    ExpectEqual(actual.singleValuedGradient, expected.singleValuedGradient);
    ASSERT_EQ(actual.defectGradient.size(), 2U);
    for (std::size_t k = 0; k < 2; ++k)
    {
      EXPECT_NEAR(WrapAngle(actual.holonomyDefect[k] - expected.holonomyDefect[k]), 0.0, 1e-11);
      ExpectEqual(actual.defectGradient[k], expected.defectGradient[k]);
    }
    EXPECT_EQ(energy.Evaluate(moved, false).renormalized.energy, actual.energy);
  }
}

/// Returns the gradient of single-valued W plus the holonomy defects times multipliers.
Eigen::VectorXd LagrangianGradient(const PositionEnergy& energy, const Configuration& configuration,
  const Eigen::VectorXd& multipliers)
{
  const RenormalizedEnergyValue value = energy.Evaluate(configuration).renormalized;
  Eigen::Matrix2Xd gradient = value.singleValuedGradient;
  for (Eigen::Index k = 0; k < multipliers.size(); ++k)
  {
    gradient += multipliers[k] * value.defectGradient[static_cast<std::size_t>(k)];
  }
  return Eigen::Map<const Eigen::VectorXd>(gradient.data(), gradient.size());
}

TEST(PositionEnergy, CurvatureIsTheDerivativeOfTheGradient)
{
  const auto potential = std::make_shared<const PointPotential>(PotentialWith(Solver(), -1, 0));
  const PositionEnergy energy(potential);
  const Eigen::VectorXd multipliers = Eigen::Vector2d(0.3, -0.7);
  const PositionCurvature curvature = Differentiate(energy, Singularities, multipliers);
  ASSERT_EQ(curvature.hessian.rows(), 10);
  EXPECT_LT(
    (curvature.hessian - curvature.hessian.transpose()).norm(), 1e-10 * curvature.hessian.norm());
  constexpr double Shift = 1e-5;
  // The response of R is that of P1, which is too small by a few per cent on this mesh.
  constexpr double Tolerance = 0.03;
  Eigen::MatrixXd differences(10, 10);
  for (Eigen::Index i = 0; i < 10; ++i)
  {
    Configuration forward = Singularities;
    Configuration backward = Singularities;
    forward[static_cast<std::size_t>(i / 2)].position[i % 2] += Shift;
    backward[static_cast<std::size_t>(i / 2)].position[i % 2] -= Shift;
    differences.col(i) = (LagrangianGradient(energy, forward, multipliers) -
                           LagrangianGradient(energy, backward, multipliers)) /
      (2.0 * Shift);
    const Eigen::VectorXd regular =
      (energy.Evaluate(forward).solution.regular - energy.Evaluate(backward).solution.regular) /
      (2.0 * Shift);
    EXPECT_LT((curvature.regular.col(i) - regular).norm(), 1e-6 * regular.norm()) << i;
  }
  EXPECT_LT((curvature.hessian - differences).norm(), Tolerance * differences.norm());
}

TEST(PositionEnergy, IsTheSameAfterAnotherAlignment)
{
  const auto solver = Solver();
  const PointPotential first = PotentialWith(solver, 0, -1);
  const PointPotential fresh = PotentialWith(solver, -1, 0);
  const PointPotential changed = first.WithAlignment(fresh.GetProblem().alignment);
  ASSERT_EQ(changed.CurveLogCount(), 1U);
  const RenormalizedEnergyValue expected =
    EvaluateRenormalizedEnergy(fresh, fresh.Solve(Singularities));
  const RenormalizedEnergyValue actual =
    EvaluateRenormalizedEnergy(changed, changed.Solve(Singularities));
  EXPECT_NEAR(actual.energy, expected.energy, 1e-10);
  ExpectEqual(actual.gradient, expected.gradient);
  // And it differs from the first one.
  EXPECT_GT(std::abs(EvaluateRenormalizedEnergy(first, first.Solve(Singularities)).energy -
              expected.energy),
    1e-3);
}

/// Returns the mesh vertex at a position.
int VertexAt(const PlanarTopology& topology, const Point& position)
{
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    if ((topology.PointAt(edge.vertices[0]) - position).norm() < 1e-9)
    {
      return edge.vertices[0];
    }
  }
  return -1;
}

/// Moves quarters from the inside to a point of a curve and to a corner, and to other places inside:
/// the energy is that of the changed configuration.
TEST(StrengthChanges, HaveTheEnergyOfTheChangedConfiguration)
{
  const auto solver = Solver();
  const PlanarTopology& topology = solver->GetTopology();
  const auto energy = std::make_shared<const PositionEnergy>(
    std::make_shared<const PointPotential>(PotentialWith(solver, -1, 0)));
  const Loop outer = topology.AlignedLoops()[0];
  const Point curve = *std::max_element(
    outer.begin(), outer.end(), [](const Point& a, const Point& b) { return a.x() < b.x(); });
  const Point top = *std::max_element(
    outer.begin(), outer.end(), [](const Point& a, const Point& b) { return a.y() < b.y(); });
  const Point corner(0.3, -0.1);

  // Quarter indices at the curve, at another point of it, and at the corner; singularities inside.
  struct Case
  {
    int atCurve;
    int atTop;
    int atCorner;
    Configuration inside;
  };
  Configuration without = Singularities; // without the last one
  without.pop_back();
  Configuration elsewhere = Singularities;
  elsewhere[4].position = { -0.5, -0.5 };
  Configuration split = Singularities;
  split[1].quarterIndex = 1;
  split.push_back({ { 0.6, -0.4 }, 1, 0.0 });
  StrengthChanges changes(energy, Singularities);
  const auto inside = [](const Point& position) { return StrengthChanges::Place{ position, -1 }; };
  const auto at = [&](const Point& position) {
    return StrengthChanges::Place{ position, VertexAt(topology, position) };
  };
  const std::vector<std::pair<Case, std::vector<StrengthChanges::Change>>> cases = {
    { { -1, 0, 0, Singularities }, {} },
    { { -2, 0, 0, without }, { { inside(Singularities[4].position), 1 }, { at(curve), -1 } } },
    { { 0, -1, 0, Singularities }, { { at(curve), 1 }, { at(top), -1 } } },
    { { -1, 0, -1, without }, { { inside(Singularities[4].position), 1 }, { at(corner), -1 } } },
    { { -1, 0, 0, elsewhere },
      { { inside(Singularities[4].position), 1 }, { inside({ -0.5, -0.5 }), -1 } } },
    { { -1, 0, 0, split },
      { { inside(Singularities[1].position), -1 }, { inside({ 0.6, -0.4 }), 1 } } },
    { { 0, -1, -1, without },
      { { inside(Singularities[4].position), 1 }, { at(curve), 1 }, { at(corner), -1 },
        { at(top), -2 }, { at(top), 1 } } },
  };
  double lowest = 0.0;
  double highest = 0.0;
  for (const auto& [expectedCase, change] : cases)
  {
    std::vector<CornerChoice> choices = { { corner, expectedCase.atCorner } };
    for (const auto& [position, quarters] :
      { std::make_pair(curve, expectedCase.atCurve), std::make_pair(top, expectedCase.atTop) })
    {
      if (quarters != 0)
      {
        choices.push_back({ position, quarters });
      }
    }
    const PointPotential changed(
      solver, AlignWithBoundary(topology, choices, TotalQuarters(expectedCase.inside)));
    const RenormalizedEnergyValue expected =
      EvaluateRenormalizedEnergy(changed, changed.Solve(expectedCase.inside));
    std::vector<StrengthChanges::Place> places;
    for (const StrengthChanges::Change& one : change)
    {
      places.push_back(one.place);
    }
    changes.Prepare(places);
    EXPECT_EQ(changes.Prepare(places), 0U);
    const StrengthChanges::Value actual = changes.Evaluate(change);
    EXPECT_NEAR(actual.energy, expected.energy, 1e-9) << change.size();
    EXPECT_NEAR(actual.logarithmCoefficient, expected.logarithmCoefficient, 1e-10);
    EXPECT_NEAR(actual.largestDefect,
      std::max(std::abs(expected.holonomyDefect[0]), std::abs(expected.holonomyDefect[1])), 1e-9);
    // The same in two parts, one after the other.
    StrengthChanges parts = changes;
    const auto half = change.begin() + static_cast<std::ptrdiff_t>(change.size() / 2);
    parts.Accept({ change.begin(), half });
    EXPECT_NEAR(parts.Evaluate({ half, change.end() }).energy, expected.energy, 1e-9);
    lowest = std::min(lowest, expected.energy);
    highest = std::max(highest, expected.energy);
  }
  EXPECT_GT(highest - lowest, 1.0); // the cases differ
}
}
}
