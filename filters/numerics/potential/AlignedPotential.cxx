#include "AlignedPotential.h"

#include "ConjugateField.h"
#include "DenseCholesky.h"
#include "GramSolve.h"

#include <Eigen/Cholesky>

namespace crossfield
{
Eigen::VectorXd TurnsOfHoles(const PotentialOperator& laplacian, double factor)
{
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(laplacian.Rows());
  for (const BoundaryLoop& loop : laplacian.GetTopology().loops)
  {
    for (const int edge : loop.edges)
    {
      if (loop.kind == BoundaryKind::Hole)
      {
        sources[laplacian.GetTopology().BoundaryAt(edge).vertices[0]] =
          factor * 2.0 * Pi * loop.quarterIndex / static_cast<double>(loop.edges.size());
      }
    }
  }
  return sources;
}

Eigen::VectorXd SolveConstantOnHoles(
  const PotentialFactor& factor, const Eigen::VectorXd& sources, PotentialOperator::Periods periods)
{
  const HoleElimination holes(factor);
  const HoleResponse response(holes, periods);
  PotentialFactor::Eliminated eliminated = factor.Eliminate(sources, periods);
  holes.AddSources(
    eliminated, SolveGram(response.elastic, -holes.Differences(eliminated)), periods);
  return factor.Substitute(eliminated);
}

double AlignedDifference(
  const PotentialProblem& problem, const AlignedSources& sources, Eigen::Index k)
{
  const Cycle& cycle = problem.Topology().cycles[k];
  return std::arg(problem.alignment.crosses[cycle.firstBoundaryEdge] *
           std::conj(problem.alignment.crosses[cycle.lastBoundaryEdge])) +
    sources.midpointShift[cycle.firstBoundaryEdge] - sources.midpointShift[cycle.lastBoundaryEdge];
}

Eigen::VectorXd NearestOffsets(const Eigen::VectorXd& defects, const Eigen::MatrixXd& inverse)
{
  Eigen::VectorXd offsets = defects;
  Eigen::VectorXd slope = inverse * offsets;
  double best = offsets.dot(slope);
  for (bool improved = true; improved;)
  {
    improved = false;
    for (Eigen::Index k = 0; k < offsets.size(); ++k)
    {
      for (double step : { 2.0 * Pi, -2.0 * Pi })
      {
        const double energy = best + step * (2.0 * slope[k] + step * inverse(k, k));
        // The margin keeps ties from cycling by rounding.
        if (energy < best * (1.0 - 1e-12))
        {
          offsets[k] += step;
          slope = inverse * offsets;
          best = offsets.dot(slope);
          improved = true;
        }
      }
    }
  }
  return offsets;
}

AlignedPotential SolveAligned(const PotentialProblem& problem, const AlignedSources& sources)
{
  const PotentialSolver& potential = *problem.potential;
  // φ is free on holes, so Φ has no periods around them.
  constexpr auto Islands = PotentialSolver::Periods::Islands;
  const Eigen::Index periods = potential.PeriodCount(Islands);

  const PotentialFactor& factor = potential.GetFactor();
  const HoleElimination& holes = potential.GetHoles();
  const HoleResponse& response = potential.GetHoleResponse(Islands);

  // 1. Solve for the potential with the sources of each hole spread over its vertices, and for the
  //    sources ∇ᵀx, which sum to zero, that make it constant there.
  PotentialFactor::Eliminated load =
    factor.Eliminate(sources.atRows + TurnsOfHoles(potential.GetOperator(), -1.0), Islands);
  Eigen::VectorXd values = SolveGram(response.elastic, -holes.Differences(load));

  // 2. Compute the phase differences of the single-valued potential, and the periods that correct
  //    them.
  AlignedPotential result;
  if (periods > 0)
  {
    // Response of holes to sources at the periods, and the resulting response of the periods.
    const Eigen::MatrixXd onHoles = SolveGram(response.elastic, response.periods);
    const Eigen::MatrixXd lower = factor.PeriodFactor(Islands);
    const Eigen::MatrixXd inverse = DenseCholesky<double>(lower * lower.transpose()).Inverse() -
      response.periods.transpose() * onHoles;
    const Eigen::VectorXd grown =
      factor.PeriodValues(load, Islands) + response.periods.transpose() * values;
    const Eigen::VectorXd carried = -inverse.llt().solve(grown);
    Eigen::VectorXd defects(periods);
    for (Eigen::Index k = 0; k < periods; ++k)
    {
      defects[k] = WrapAngle(AlignedDifference(problem, sources, k) - carried[k]);
      result.holonomyDefect.push_back(defects[k]);
    }
    result.carriedPhase = carried + NearestOffsets(defects, inverse);
    factor.AddPeriodSources(load, result.carriedPhase, Islands);
    values -= onHoles * result.carriedPhase;
  }

  // 3. The potential.
  holes.AddSources(load, values, Islands);
  result.solution = factor.Substitute(load);
  result.gradient = potential.Gradient(result.solution);
  result.energy = GradientEnergy(problem.Topology(), result.gradient);
  return result;
}
}
