#include "AlignedPotential.h"

#include "ConjugateField.h"
#include "DenseCholesky.h"
#include "GramSolve.h"

#include <Eigen/Cholesky>

namespace crossfield
{
Eigen::VectorXd TurnsOfHoles(const PotentialSolver& potential, double factor)
{
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(potential.Rows());
  for (const BoundaryLoop& loop : potential.GetTopology().loops)
  {
    for (const int edge : loop.edges)
    {
      if (loop.kind == BoundaryKind::Hole)
      {
        sources[potential.GetTopology().BoundaryAt(edge).vertices[0]] =
          factor * 2.0 * Pi * loop.quarterIndex / static_cast<double>(loop.edges.size());
      }
    }
  }
  return sources;
}

Eigen::VectorXd SolveConstantOnHoles(const PotentialSolver& potential,
  const Eigen::VectorXd& sources, PotentialSolver::Periods periods)
{
  PotentialSolver::Eliminated eliminated = potential.Eliminate(sources, periods);
  potential.AddOnHoles(eliminated,
    SolveGram(potential.GetHoleResponse(periods).elastic, -potential.OnHoles(eliminated)), periods);
  return potential.Substitute(eliminated);
}

double AlignedDifference(
  const PotentialProblem& problem, const AlignedSources& sources, Eigen::Index k)
{
  const LoopStrip& strip = problem.potential->GetStrips()[static_cast<std::size_t>(k)];
  return std::arg(problem.alignment.crosses[strip.firstBoundaryEdge] *
           std::conj(problem.alignment.crosses[strip.lastBoundaryEdge])) +
    sources.midpointShift[strip.firstBoundaryEdge] - sources.midpointShift[strip.lastBoundaryEdge];
}

Eigen::VectorXd NearestOffsets(const Eigen::VectorXd& defects, const Eigen::MatrixXd& inverse)
{
  Eigen::VectorXd offsets = defects;
  double best = offsets.dot(inverse * offsets);
  for (bool improved = true; improved;)
  {
    improved = false;
    for (Eigen::Index k = 0; k < offsets.size(); ++k)
    {
      for (double step : { 2.0 * Pi, -2.0 * Pi })
      {
        Eigen::VectorXd trial = offsets;
        trial[k] += step;
        const double energy = trial.dot(inverse * trial);
        // A tie must not be walked around in circles by rounding.
        if (energy < best * (1.0 - 1e-12))
        {
          offsets = trial;
          best = energy;
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

  const PotentialSolver::HoleResponse& response = potential.GetHoleResponse(Islands);

  // 1. The potential with the sources of each hole spread over its vertices, and what has to be added to them so that
  //    it is constant there: differences of values x on its edges, which have no sum.
  PotentialSolver::Eliminated load =
    potential.Eliminate(sources.atRows + TurnsOfHoles(potential, -1.0), Islands);
  Eigen::VectorXd values = SolveGram(response.elastic, -potential.OnHoles(load));

  // 2. Single-valued first: what phase difference would the periods' equations carry?
  AlignedPotential result;
  if (periods > 0)
  {
    // What sources at the periods do to holes and, with these, to the periods.
    const Eigen::MatrixXd onHoles = SolveGram(response.elastic, response.periods);
    const Eigen::MatrixXd lower = potential.PeriodFactor(Islands);
    const Eigen::MatrixXd inverse = DenseCholesky<double>(lower * lower.transpose()).Inverse() -
      response.periods.transpose() * onHoles;
    const Eigen::VectorXd grown =
      potential.AtPeriods(load, Islands) + response.periods.transpose() * values;
    const Eigen::VectorXd carried = -inverse.llt().solve(grown);
    Eigen::VectorXd defects(periods);
    for (Eigen::Index k = 0; k < periods; ++k)
    {
      defects[k] = WrapAngle(AlignedDifference(problem, sources, k) - carried[k]);
      result.holonomyDefect.push_back(defects[k]);
    }
    result.carriedPhase = carried + NearestOffsets(defects, inverse);
    potential.AddAtPeriods(load, result.carriedPhase, Islands);
    values -= onHoles * result.carriedPhase;
  }

  // 3. The potential.
  potential.AddOnHoles(load, values, Islands);
  result.solution = potential.Substitute(load);
  result.gradient = potential.Gradient(result.solution);
  result.energy = GradientEnergy(problem.Topology().mesh, result.gradient);
  return result;
}
}
