#include "PotentialReduction.h"

#include "ConjugateField.h"

namespace crossfield
{
namespace
{
/// Returns the sources of the conjugates of Re u and Im u at the vertices of aligned loops, and the
/// differences between the ends of the strips.
Eigen::MatrixXd AlignedLoad(const PotentialProblem& problem)
{
  const PotentialSolver& potential = *problem.potential;
  const PlanarTopology& topology = problem.Topology();
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
    const Cycle& cycle = topology.cycles[k];
    // On a hole the cross is 0, because the values on its edges are unknowns.
    set(potential.PeriodRow(k), crosses[cycle.firstBoundaryEdge] - crosses[cycle.lastBoundaryEdge]);
  }
  return load;
}
}

PotentialReduction::PotentialReduction(
  const PotentialProblem& problem, PotentialSolver::Periods periods)
  : Problem(problem)
  , Periods(periods)
  , Aligned(problem.potential->GetFactor().Eliminate(AlignedLoad(problem), periods))
{
  const PotentialSolver& potential = *problem.potential;
  const PlanarTopology& topology = problem.Topology();
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      this->Reduced.constraints.push_back(
        ConstrainLoop(topology, loop, static_cast<int>(this->HoleEdges.size())));
      for (const int edge : loop.edges)
      {
        this->HoleEdges.push_back(topology.EdgeOfBoundary(edge));
      }
    }
  }
  this->Reduced.matrix = potential.GetHoleResponse(periods).elastic;
  const Eigen::MatrixXd load = -potential.GetHoles().Differences(this->Aligned);
  this->Reduced.load.resize(load.rows());
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
    if (this->Periods == PotentialSolver::Periods::IslandsAndHoles)
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
  const PlanarTopology& topology = this->Problem.Topology();
  const PotentialSolver& potential = *this->Problem.potential;
  Eigen::MatrixXd values(x.size(), 2);
  values << x.real(), x.imag();
  PotentialFactor::Eliminated sources = this->Aligned;
  potential.GetHoles().AddSources(sources, values, this->Periods);
  const Eigen::MatrixXd gradient = potential.Gradient(potential.GetFactor().Substitute(sources));

  RecoveredField field;
  field.energy = GradientEnergy(topology, gradient);
  const int first = topology.FirstOuterEdge();
  const Complex start = this->Problem.alignment.crosses[first];
  const Eigen::MatrixXd parts = IntegrateConjugate(topology, gradient,
    topology.EdgeOfBoundary(first), Eigen::Vector2d(start.real(), start.imag()));
  field.u.resize(parts.cols());
  field.u.real() = parts.row(0);
  field.u.imag() = parts.row(1);
  field.alignmentResidual = SetAlignedCrosses(topology, this->Problem.alignment, field.u);
  return field;
}
}
