#include "UnitNormField.h"

#include "AlignedPotential.h"
#include "ConjugateField.h"
#include "Parts.h"

namespace crossfield
{
UnitNormField SolveUnitNorm(const PotentialProblem& problem)
{
  AlignedPotential potential = SolveAligned(problem, PiecewiseConstantPhase(problem));
  UnitNormField result;
  result.energy = potential.energy;
  result.holonomyDefect = potential.holonomyDefect;
  // The phase follows from the gradient turned by 90°, summed from edge to edge.
  const PlanarTopology& topology = problem.Topology();
  const int first = topology.FirstOuterEdge();
  const Eigen::RowVectorXd phase =
    IntegrateConjugate(topology, potential.gradient, topology.EdgeOfBoundary(first),
      Eigen::VectorXd::Constant(1, std::arg(problem.alignment.crosses[first])));
  result.u.resize(phase.size());
  ForRanges(phase.size(),
    [&](int begin, int end)
    {
      for (int e = begin; e < end; ++e)
      {
        result.u[e] = std::polar(1.0, phase[e]);
      }
    });
  result.residual = SetAlignedCrosses(topology, problem.alignment, result.u);
  result.potential = std::move(potential.solution);
  return result;
}
}
