#include "PerforatedEnergy.h"

#include "AlignedPotential.h"
#include "ConformingPhase.h"
#include "ConjugateField.h"

#include <utility>

namespace crossfield
{
PerforatedEnergy ComputePerforatedEnergy(
  const SharedTopology& topology, const std::vector<CornerChoice>& corners)
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

  const PotentialSolver& given = problem.potential->OfGivenBoundary();
  const EdgePhases linearPhases = LinearEdgePhases(problem);
  ConformingPhase phase(*problem.potential, linearPhases.end - linearPhases.start);
  if (topology->LoopCount(BoundaryKind::Inner) > 0)
  {
    phase.ShiftInnerLoops(linear.carriedPhase);
  }
  const Eigen::VectorXd inside = given.Solve(-given.Apply(phase.Get()), Everywhere);
  result.alignedUpper = GradientEnergy(topology->mesh, given.Gradient(phase.Get() + inside));

  // Free along the boundary. Of Φ only the constants on the holes matter, of φ only the periods around them.
  const Eigen::VectorXd spread = TurnsOfHoles(given, 1.0);
  result.degreeOnlyLower = 0.5 * spread.dot(SolveConstantOnHoles(given, spread, Everywhere));
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
    problem.potential->PeriodFactor(Everywhere).bottomRightCorner(holes, holes);
  result.degreeOnlyUpper =
    0.5 * (periods.triangularView<Eigen::Lower>().transpose() * turns).squaredNorm();
  return result;
}
}
