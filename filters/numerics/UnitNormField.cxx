#include "UnitNormField.h"

#include "ConjugateField.h"

#include <Eigen/Cholesky>
#include <Eigen/LU>

#include <cmath>

namespace crossfield
{
namespace
{
/// Sources of the conjugate potential at the vertices of outer and inner loops.
Eigen::VectorXd AlignedSources(const PerforatedProblem& problem)
{
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(problem.potential->Rows());
  const auto& mesh = problem.mesh;
  const auto direction = [&mesh](const BoundaryEdge& edge)
  {
    return Point(mesh.points[static_cast<std::size_t>(edge.vertices[1])] -
      mesh.points[static_cast<std::size_t>(edge.vertices[0])]);
  };
  const std::vector<int> previous = problem.PreviousBoundaryEdges();
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = mesh.boundary[i];
    if (edge.kind != BoundaryKind::Hole)
    {
      const BoundaryEdge& before = mesh.boundary[static_cast<std::size_t>(previous[i])];
      const double turning = AngleBetween(direction(before), direction(edge));
      const auto chosen = problem.chosenQuarters.find(edge.vertices[0]);
      sources[edge.vertices[0]] = chosen == problem.chosenQuarters.end()
        ? 4.0 * SmallestRotation(turning)
        : 4.0 * turning - 2.0 * Pi * chosen->second;
    }
  }
  return sources;
}

/// The trailing unknowns in terms of one constant per hole and the periods.
Eigen::MatrixXd MergeHoles(const PerforatedProblem& problem)
{
  const auto rows = static_cast<Eigen::Index>(problem.potential->TrailingRows().size());
  const Eigen::Index periods = problem.potential->PeriodCount();
  std::vector<Eigen::Index> sizes;
  for (const BoundaryLoop& loop : problem.loops)
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
  merge.bottomRightCorner(periods, periods).setIdentity();
  return merge;
}

double Wrap(double angle)
{
  const double wrapped = std::remainder(angle, 2.0 * Pi);
  return wrapped == -Pi ? Pi : wrapped;
}

/// The offsets 2π n_k + defect_k of least ½ offsetᵀ P⁻¹ offset, by steps of one n_k at a time.
Eigen::VectorXd ChooseOffsets(const Eigen::VectorXd& defects, const Eigen::MatrixXd& inverse)
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
}

UnitNormField SolveUnitNorm(const PerforatedProblem& problem)
{
  const PotentialSolver& potential = *problem.potential;
  const Eigen::Index periods = potential.PeriodCount();

  // 1. The potential without hole sources: until they enter the dense problem below, the ground
  //    takes what is missing.
  Eigen::VectorXd holeSources = Eigen::VectorXd::Zero(potential.TrailingFactor().rows());
  Eigen::Index row = 0;
  for (const BoundaryLoop& loop : problem.loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      holeSources[row] = -2.0 * Pi * loop.quarterIndex;
      row += static_cast<Eigen::Index>(loop.edges.size());
    }
  }
  const PotentialSolver::Eliminated aligned = potential.Eliminate(AlignedSources(problem));
  const Eigen::VectorXd freeTrailing = aligned.trailing;

  // 2. The dense problem on hole constants and periods.
  const Eigen::MatrixXd merge = MergeHoles(problem);
  const auto lower = potential.TrailingFactor().triangularView<Eigen::Lower>();
  const Eigen::VectorXd reducedLoad = lower * (lower.transpose() * freeTrailing) + holeSources;
  const Eigen::MatrixXd root = lower.transpose() * merge;
  const Eigen::MatrixXd matrix = root.transpose() * root;
  const Eigen::VectorXd mergedLoad = merge.transpose() * reducedLoad;
  const Eigen::Index holes = matrix.rows() - periods;
  const Eigen::LLT<Eigen::MatrixXd> holeFactor(matrix.topLeftCorner(holes, holes));

  // 3. Single-valued first: what phase difference would the periods' equations carry?
  UnitNormField result;
  Eigen::VectorXd values = Eigen::VectorXd::Zero(matrix.rows());
  values.head(holes) = holeFactor.solve(mergedLoad.head(holes));
  Eigen::VectorXd periodLoad = Eigen::VectorXd::Zero(periods);
  if (periods > 0)
  {
    const auto coupling = matrix.bottomLeftCorner(periods, holes);
    const Eigen::VectorXd carried = coupling * values.head(holes) - mergedLoad.tail(periods);
    Eigen::VectorXd defects(periods);
    for (Eigen::Index k = 0; k < periods; ++k)
    {
      const LoopStrip& strip = potential.GetStrips()[static_cast<std::size_t>(k)];
      const double wanted = std::arg(problem.aligned[strip.firstBoundaryEdge] *
        std::conj(problem.aligned[strip.lastBoundaryEdge]));
      defects[k] = Wrap(wanted - carried[k]);
      result.holonomyDefect.push_back(defects[k]);
    }
    const Eigen::MatrixXd inverse =
      (matrix.bottomRightCorner(periods, periods) -
        coupling * holeFactor.solve(coupling.transpose()))
        .inverse();
    periodLoad = carried + ChooseOffsets(defects, inverse);
    Eigen::VectorXd fullLoad = mergedLoad;
    fullLoad.tail(periods) += periodLoad;
    values = matrix.llt().solve(fullLoad);
  }

  // 4. The forces on the trailing unknowns that keep every hole constant, and the potential.
  const Eigen::VectorXd forces =
    lower * (lower.transpose() * (merge * values - freeTrailing));
  const Eigen::MatrixXd gradient = potential.Gradient(potential.Substitute(aligned, forces));
  result.energy = GradientEnergy(problem.mesh, gradient);

  // 5. The phase by rotation and summation along edges.
  const int first = problem.FirstOuterEdge();
  const Eigen::RowVectorXd phase = IntegrateConjugate(problem.mesh, problem.edges, gradient,
    problem.edges.ofBoundary[static_cast<std::size_t>(first)], Eigen::VectorXd::Constant(1, std::arg(problem.aligned[first])));
  result.u.resize(phase.size());
  for (Eigen::Index e = 0; e < phase.size(); ++e)
  {
    result.u[e] = std::polar(1.0, phase[e]);
  }
  result.residual = problem.Align(result.u);
  return result;
}
}
