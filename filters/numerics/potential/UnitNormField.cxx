#include "UnitNormField.h"

#include "AlignedPotential.h"
#include "ConjugateField.h"

namespace crossfield
{
UnitNormField SolveUnitNorm(const PerforatedProblem& problem)
{
  AlignedPotential potential = SolveAligned(problem, PiecewiseConstantPhase(problem));
  UnitNormField result;
  result.energy = potential.energy;
  result.holonomyDefect = potential.holonomyDefect;
  // The phase by rotation and summation along edges.
  const int first = problem.FirstOuterEdge();
  const Eigen::RowVectorXd phase = IntegrateConjugate(problem.mesh, problem.edges,
    potential.gradient, problem.edges.ofBoundary[static_cast<std::size_t>(first)],
    Eigen::VectorXd::Constant(1, std::arg(problem.aligned[first])));
  result.u.resize(phase.size());
  for (Eigen::Index e = 0; e < phase.size(); ++e)
  {
    result.u[e] = std::polar(1.0, phase[e]);
  }
  result.residual = problem.Align(result.u);
  result.potential = std::move(potential.solution);
  return result;
}
}
