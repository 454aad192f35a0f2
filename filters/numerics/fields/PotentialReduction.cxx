#include "PotentialReduction.h"

#include "CholeskyInverse.h"
#include "ConjugateField.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Sources of the conjugates of Re u and Im u at the vertices of aligned loops, and the differences
/// between the ends of the strips.
Eigen::MatrixXd AlignedLoad(const PotentialProblem& problem)
{
  const PotentialSolver& potential = *problem.potential;
  const MeshTopology& topology = problem.Topology();
  const ComplexVector& crosses = problem.alignment.crosses;
  Eigen::MatrixXd load = Eigen::MatrixXd::Zero(potential.Rows(), 2);
  const auto set = [&load](Eigen::Index row, const Complex& value)
  { load.row(row) << value.real(), value.imag(); };
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = topology.mesh.boundary[i];
    if (edge.IsAligned())
    {
      set(edge.vertices[0], crosses[static_cast<Eigen::Index>(i)] - crosses[topology.previous[i]]);
    }
  }
  for (Eigen::Index k = 0; k < potential.PeriodCount(); ++k)
  {
    const LoopStrip& strip = potential.GetStrips()[static_cast<std::size_t>(k)];
    // On a hole the cross is 0; what its edges contribute is an unknown.
    set(potential.PeriodRow(k), crosses[strip.firstBoundaryEdge] - crosses[strip.lastBoundaryEdge]);
  }
  return load;
}
}

PotentialReduction::PotentialReduction(
  const PotentialProblem& problem, PotentialSolver::Periods periods)
  : Problem(problem)
  , ConstantsCount(periods == PotentialSolver::Periods::IslandsAndHoles)
  , Aligned(problem.potential->Eliminate(AlignedLoad(problem), periods))
{
  const PotentialSolver& potential = *problem.potential;
  const MeshTopology& topology = problem.Topology();
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::Index holePeriod = potential.PeriodCount(PotentialSolver::Periods::Islands);
  const auto holeVertices =
    static_cast<int>(potential.TrailingCount(periods) - potential.PeriodCount(periods));
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind != BoundaryKind::Hole)
    {
      continue;
    }
    const auto first = static_cast<int>(this->HoleEdges.size());
    const auto size = static_cast<int>(loop.edges.size());
    for (int j = 0; j < size; ++j)
    {
      this->HoleEdges.push_back(topology.EdgeOfBoundary(loop.edges[static_cast<std::size_t>(j)]));
      entries.emplace_back(first + j, first + j, 1.0);
      entries.emplace_back(first + j, first + (j + 1) % size, -1.0);
    }
    if (this->ConstantsCount)
    {
      const int last = potential.GetStrips()[static_cast<std::size_t>(holePeriod)].lastBoundaryEdge;
      const auto position = std::find(loop.edges.begin(), loop.edges.end(), last);
      entries.emplace_back(holeVertices + static_cast<int>(holePeriod),
        first + static_cast<int>(position - loop.edges.begin()), -1.0);
    }
    ++holePeriod;
    this->Reduced.constraints.push_back(ConstrainLoop(topology, loop, first));
  }

  const auto count = static_cast<Eigen::Index>(this->HoleEdges.size());
  const Eigen::Index trailing = potential.TrailingCount(periods);
  this->Differences.resize(trailing, count);
  this->Differences.setFromTriplets(entries.begin(), entries.end());
  if (trailing == 0)
  {
    return; // neither holes nor inner loops: nothing is left to choose
  }
  // Differences of T⁻¹, which LAPACK makes from the factor of T in less time than a product of matrices takes.
  const Eigen::MatrixXd response =
    CholeskyInverse(potential.TrailingFactor(periods)) * this->Differences;
  this->Reduced.matrix = this->Differences.transpose() * response;
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

ComplexVector PotentialReduction::ValuesOf(const ComplexVector& u) const
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

RecoveredField PotentialReduction::Recover(const ComplexVector& x) const
{
  const MeshTopology& topology = this->Problem.Topology();
  const PotentialSolver& potential = *this->Problem.potential;
  const ComplexVector sources = this->Differences * x;
  Eigen::MatrixXd added(sources.size(), 2);
  added << sources.real(), sources.imag();
  const Eigen::MatrixXd gradient = potential.Gradient(potential.Substitute(this->Aligned, added));

  RecoveredField field;
  field.energy = GradientEnergy(topology.mesh, gradient);
  const int first = topology.FirstOuterEdge();
  const Complex start = this->Problem.alignment.crosses[first];
  const Eigen::MatrixXd values = IntegrateConjugate(topology.mesh, topology.edges, gradient,
    topology.EdgeOfBoundary(first), Eigen::Vector2d(start.real(), start.imag()));
  field.u.resize(values.cols());
  field.u.real() = values.row(0);
  field.u.imag() = values.row(1);
  field.alignmentResidual = SetAlignedCrosses(topology, this->Problem.alignment, field.u);
  return field;
}
}
