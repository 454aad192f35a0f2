#include "ConstrainedField.h"

#include "ConjugateField.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Sources of the conjugates of Re u and Im u at the vertices of aligned loops, and the differences
/// between the ends of the islands' strips.
Eigen::MatrixXd AlignedLoad(const PerforatedProblem& problem)
{
  const PotentialSolver& potential = *problem.potential;
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(potential.Rows(), 2);
  const auto set = [&load](Eigen::Index row, const Complex& value)
  { load.row(row) << value.real(), value.imag(); };
  const std::vector<int> previous = problem.PreviousBoundaryEdges();
  for (std::size_t i = 0; i < problem.mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = problem.mesh.boundary[i];
    if (edge.kind != BoundaryKind::Hole)
    {
      set(edge.vertices[0],
        problem.aligned[static_cast<Eigen::Index>(i)] - problem.aligned[previous[i]]);
    }
  }
  for (Eigen::Index k = 0; k < potential.PeriodCount(); ++k)
  {
    const LoopStrip& strip = potential.GetStrips()[static_cast<std::size_t>(k)];
    // On a hole `aligned` is 0; what its edges contribute is an unknown.
    set(potential.PeriodRow(k),
      problem.aligned[strip.firstBoundaryEdge] - problem.aligned[strip.lastBoundaryEdge]);
  }
  return load;
}

Point Midpoint(const TriangleMesh& mesh, const BoundaryEdge& edge)
{
  return 0.5 *
    (mesh.points[static_cast<std::size_t>(edge.vertices[0])] +
      mesh.points[static_cast<std::size_t>(edge.vertices[1])]);
}
}

ConstrainedSolver::ConstrainedSolver(const PerforatedProblem& problem)
  : Problem(problem)
  , Aligned(problem.potential->Eliminate(AlignedLoad(problem)))
{
  for (const BoundaryLoop& loop : problem.loops)
  {
    if (loop.kind != BoundaryKind::Hole)
    {
      continue;
    }
    std::vector<int> positions;
    std::vector<Point> midpoints;
    for (int edge : loop.edges)
    {
      positions.push_back(static_cast<int>(this->HoleEdges.size()));
      this->HoleEdges.push_back(problem.edges.ofBoundary[static_cast<std::size_t>(edge)]);
      this->NextOnHole.push_back(positions.back() + 1);
      midpoints.push_back(
        Midpoint(problem.mesh, problem.mesh.boundary[static_cast<std::size_t>(edge)]));
    }
    this->NextOnHole.back() = positions.front();
    this->Reduced.constraints.push_back(MakeDegreeConstraint(
      std::move(positions), midpoints, CentreOf(loop, problem.mesh), loop.quarterIndex));
  }

  const PotentialSolver& potential = *problem.potential;
  const auto count = static_cast<Eigen::Index>(this->HoleEdges.size());
  const auto trailing = static_cast<Eigen::Index>(potential.TrailingRows().size());
  std::vector<Eigen::Triplet<double>> entries;
  for (int j = 0; j < static_cast<int>(count); ++j)
  {
    entries.emplace_back(j, j, 1.0);
    entries.emplace_back(j, this->NextOnHole[static_cast<std::size_t>(j)], -1.0);
  }
  for (Eigen::Index k = 0; k < potential.PeriodCount(); ++k)
  {
    const int last = potential.GetStrips()[static_cast<std::size_t>(k)].lastBoundaryEdge;
    if (problem.mesh.boundary[static_cast<std::size_t>(last)].kind == BoundaryKind::Hole)
    {
      const int edge = problem.edges.ofBoundary[static_cast<std::size_t>(last)];
      const auto position = std::find(this->HoleEdges.begin(), this->HoleEdges.end(), edge);
      entries.emplace_back(
        static_cast<int>(count + k), static_cast<int>(position - this->HoleEdges.begin()), -1.0);
      this->ConstantsCount = true;
    }
  }
  this->Differences.resize(trailing, count);
  this->Differences.setFromTriplets(entries.begin(), entries.end());
  if (trailing == 0)
  {
    return; // neither holes nor inner loops: nothing is left to choose
  }
  const Eigen::MatrixXd root = potential.TrailingFactor().triangularView<Eigen::Lower>().solve(
    Eigen::MatrixXd(this->Differences));
  this->Reduced.matrix = Eigen::MatrixXd::Zero(count, count);
  this->Reduced.matrix.selfadjointView<Eigen::Lower>().rankUpdate(root.transpose());
  this->Reduced.matrix.triangularView<Eigen::StrictlyUpper>() = this->Reduced.matrix.transpose();
  if (!this->ConstantsCount)
  {
    // The gauge: any positive weight will do; the mean of the diagonal keeps the matrix well scaled.
    const double weight =
      count > 0 ? this->Reduced.matrix.trace() / static_cast<double>(count) : 0.0;
    for (const DegreeConstraint& constraint : this->Reduced.constraints)
    {
      const auto first = static_cast<Eigen::Index>(constraint.unknowns.front());
      const auto size = static_cast<Eigen::Index>(constraint.unknowns.size());
      this->Reduced.matrix.block(first, first, size, size).array() +=
        weight / static_cast<double>(size);
    }
  }

  const Eigen::MatrixXd load = -(this->Differences.transpose() * this->Aligned.trailing);
  this->Reduced.load.resize(count);
  this->Reduced.load.real() = load.col(0);
  this->Reduced.load.imag() = load.col(1);
}

ComplexVector ConstrainedSolver::HoleValues(const ComplexVector& u) const
{
  ComplexVector values(static_cast<Eigen::Index>(this->HoleEdges.size()));
  for (std::size_t j = 0; j < this->HoleEdges.size(); ++j)
  {
    values[static_cast<Eigen::Index>(j)] = u[this->HoleEdges[j]];
  }
  for (const DegreeConstraint& constraint : this->Reduced.constraints)
  {
    if (this->ConstantsCount)
    {
      break;
    }
    auto part = values.segment(static_cast<Eigen::Index>(constraint.unknowns.front()),
      static_cast<Eigen::Index>(constraint.unknowns.size()));
    part.array() -= part.mean();
  }
  return values;
}

ConstrainedField ConstrainedSolver::Recover(const ReducedSolution& solution) const
{
  const PerforatedProblem& problem = this->Problem;
  const PotentialSolver& potential = *problem.potential;
  const ComplexVector sources = this->Differences * solution.x;
  Eigen::MatrixXd added(sources.size(), 2);
  added << sources.real(), sources.imag();
  const Eigen::MatrixXd gradient = potential.Gradient(potential.Substitute(this->Aligned, added));

  ConstrainedField field;
  field.reduced = solution;
  field.energy = GradientEnergy(problem.mesh, gradient);
  const int first = problem.FirstOuterEdge();
  const Complex start = problem.aligned[first];
  const Eigen::MatrixXd values = IntegrateConjugate(problem.mesh, problem.edges, gradient,
    problem.edges.ofBoundary[static_cast<std::size_t>(first)],
    Eigen::Vector2d(start.real(), start.imag()));
  field.u.resize(values.cols());
  field.u.real() = values.row(0);
  field.u.imag() = values.row(1);
  field.alignmentResidual = problem.Align(field.u);
  return field;
}
}
