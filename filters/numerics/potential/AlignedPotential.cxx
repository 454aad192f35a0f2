#include "AlignedPotential.h"

#include "ConjugateField.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

namespace crossfield
{
Eigen::MatrixXd MergeHoles(const PotentialProblem& problem)
{
  const auto rows = problem.potential->TrailingCount(PotentialSolver::Periods::Islands);
  const Eigen::Index periods = problem.potential->PeriodCount(PotentialSolver::Periods::Islands);
  std::vector<Eigen::Index> sizes;
  for (const BoundaryLoop& loop : problem.Topology().loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      sizes.push_back(static_cast<Eigen::Index>(loop.edges.size()));
    }
  }
  const auto holes = static_cast<Eigen::Index>(sizes.size());
  Eigen::MatrixXd merge = Eigen::MatrixXd::Zero(rows, holes + periods);
  Eigen::Index row = 0;
  for (Eigen::Index hole = 0; hole < holes; ++hole)
  {
    const Eigen::Index size = sizes[static_cast<std::size_t>(hole)];
    merge.block(row, hole, size, 1).setOnes();
    row += size;
  }
  merge.block(row, holes, periods, periods).setIdentity();
  return merge;
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

  // 1. The potential without hole sources: until they enter the dense problem below, the ground
  //    takes what is missing.
  Eigen::VectorXd holeSources = Eigen::VectorXd::Zero(potential.TrailingCount(Islands));
  Eigen::Index row = 0;
  for (const BoundaryLoop& loop : problem.Topology().loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      holeSources[row] = -2.0 * Pi * loop.quarterIndex;
      row += static_cast<Eigen::Index>(loop.edges.size());
    }
  }
  const PotentialSolver::Eliminated aligned = potential.Eliminate(sources.atRows, Islands);
  const Eigen::VectorXd freeTrailing = aligned.trailing;

  // 2. The dense problem on hole constants and periods.
  const Eigen::MatrixXd merge = MergeHoles(problem);
  const auto trailingFactor = potential.TrailingFactor(Islands);
  const auto lower = trailingFactor.triangularView<Eigen::Lower>();
  const Eigen::VectorXd reducedLoad = lower * (lower.transpose() * freeTrailing) + holeSources;
  const Eigen::MatrixXd root = lower.transpose() * merge;
  const Eigen::MatrixXd matrix = root.transpose() * root;
  const Eigen::VectorXd mergedLoad = merge.transpose() * reducedLoad;
  const Eigen::Index holes = matrix.rows() - periods;
  const Eigen::LLT<Eigen::MatrixXd> holeFactor(matrix.topLeftCorner(holes, holes));

  // 3. Single-valued first: what phase difference would the periods' equations carry?
  AlignedPotential result;
  Eigen::VectorXd values = Eigen::VectorXd::Zero(matrix.rows());
  values.head(holes) = holeFactor.solve(mergedLoad.head(holes));
  if (periods > 0)
  {
    const auto coupling = matrix.bottomLeftCorner(periods, holes);
    const Eigen::VectorXd carried = coupling * values.head(holes) - mergedLoad.tail(periods);
    Eigen::VectorXd defects(periods);
    for (Eigen::Index k = 0; k < periods; ++k)
    {
      defects[k] = WrapAngle(AlignedDifference(problem, sources, k) - carried[k]);
      result.holonomyDefect.push_back(defects[k]);
    }
    const Eigen::MatrixXd inverse = (matrix.bottomRightCorner(periods, periods) -
      coupling * holeFactor.solve(coupling.transpose()))
                                      .inverse();
    result.carriedPhase = carried + NearestOffsets(defects, inverse);
    Eigen::VectorXd fullLoad = mergedLoad;
    fullLoad.tail(periods) += result.carriedPhase;
    values = matrix.llt().solve(fullLoad);
  }

  // 4. The forces on the trailing unknowns that keep every hole constant, and the potential.
  const Eigen::VectorXd forces = lower * (lower.transpose() * (merge * values - freeTrailing));
  result.solution = potential.Substitute(aligned, forces);
  result.gradient = potential.Gradient(result.solution);
  result.energy = GradientEnergy(problem.Topology().mesh, result.gradient);
  return result;
}
}
