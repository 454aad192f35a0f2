#include "PerforatedEnergy.h"

#include "AlignedPotential.h"
#include "ConformingPhase.h"
#include "ConjugateField.h"

#include <utility>

namespace crossfield
{
PerforatedEnergy ComputePerforatedEnergy(
  const SharedPlanarTopology& topology, const std::vector<CornerChoice>& corners)
{
  PerforatedEnergy result;
  constexpr auto Everywhere = PotentialSolver::Periods::IslandsAndHoles;
  Alignment alignment = AlignWithBoundary(*topology, corners);
  RequireConsistent(alignment.count);
  const PotentialProblem problem(
    std::make_shared<const PotentialSolver>(topology), std::move(alignment));
  const AlignedPotential linear = SolveAligned(problem, LinearPhase(problem));
  result.alignedLower = linear.energy;
  result.holonomyDefect = linear.holonomyDefect;

  const PotentialOperator& laplacian = problem.potential->GetOperator();
  const DirichletSolver& dirichlet = problem.potential->GetDirichlet();
  const EdgePhases linearPhases = LinearEdgePhases(problem);
  const ConformingPhase::Steps steps(laplacian);
  ConformingPhase phase(laplacian, steps, linearPhases.end - linearPhases.start);
  if (topology->LoopCount(BoundaryKind::Inner) > 0)
  {
    phase.ShiftInnerLoops(linear.carriedPhase);
  }
  result.alignedUpper =
    GradientEnergy(*topology, laplacian.Gradient(dirichlet.Harmonic(phase.Get())));

  // With a free boundary, only the constants of Φ on the holes and the periods of φ around them
  // matter.
  const Eigen::VectorXd spread = TurnsOfHoles(laplacian, 1.0);
  result.degreeOnlyLower =
    0.5 * spread.dot(SolveConstantOnHoles(dirichlet.GetFactor(), spread, Everywhere));
  const Eigen::Index holes = topology->LoopCount(BoundaryKind::Hole);
  Eigen::VectorXd turns(holes);
  Eigen::Index hole = 0;
  for (const BoundaryLoop& loop : problem.Topology().loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      turns[hole++] = 2.0 * Pi * loop.quarterIndex;
    }
  }
  const Eigen::MatrixXd periods =
    problem.potential->GetFactor().PeriodFactor(Everywhere).bottomRightCorner(holes, holes);
  result.degreeOnlyUpper =
    0.5 * (periods.triangularView<Eigen::Lower>().transpose() * turns).squaredNorm();
  return result;
}
}
