#include "VertexPotential.h"

#include "Error.h"

#include <Eigen/LU>

#include <numeric>
#include <string>
#include <utility>

namespace crossfield
{
namespace
{
SharedTopology WithoutHoles(SharedTopology topology)
{
  if (topology->LoopCount(BoundaryKind::Hole) > 0)
  {
    throw Error("The mesh has holes of singularities; give one without.");
  }
  return topology;
}

Eigen::VectorXd SourcesOfCurvature(const PotentialOperator& laplacian)
{
  const MeshTopology& topology = laplacian.GetTopology();
  Eigen::VectorXd sources = Eigen::VectorXd::Zero(laplacian.Rows());
  for (int vertex = 0; vertex < topology.VertexCount(); ++vertex)
  {
    sources[vertex] = 4.0 * topology.CurvatureAt(vertex);
  }
  for (int i = 0; i < static_cast<int>(topology.mesh.boundary.size()); ++i)
  {
    sources[topology.BoundaryAt(i).vertices[0]] = 4.0 * topology.turning[i];
  }
  return sources;
}

/// Returns the source at the period of a cycle, φ on its first edge minus φ on its last one, for which the
/// phase follows the boundary at both ends of a strip, or returns to itself, modulo 2π.
double WantedPhase(const MeshTopology& topology, const Cycle& cycle)
{
  double angle = 0.0;
  for (std::size_t i = 0; i < cycle.steps.size(); ++i)
  {
    const Cycle::Step& step = cycle.steps[i];
    if (cycle.IsClosed() || i + 1 < cycle.steps.size())
    {
      angle += topology.Hinge(step.triangle, step.exit);
    }
  }
  if (!cycle.IsClosed())
  {
    angle += topology.DirectionOf(cycle.steps.front().triangle, cycle.steps.front().entry) -
      topology.DirectionOf(cycle.steps.back().triangle, cycle.steps.back().exit);
  }
  return 4.0 * angle;
}

/// Returns VertexPotential::Growth.
Eigen::MatrixXd GrowthOf(const PotentialOperator& laplacian, const PeriodResponse& response)
{
  const MeshTopology& topology = laplacian.GetTopology();
  Eigen::MatrixXd growth = response.inverse;
  const Eigen::MatrixXd gradient = laplacian.Gradient(response.basis);
  for (Eigen::Index k = 0; k < growth.rows(); ++k)
  {
    const Cycle& cycle = topology.cycles[k];
    if (!cycle.IsClosed())
    {
      continue;
    }
    growth.row(k).setZero();
    for (const Cycle::Step& step : cycle.steps)
    {
      const Point along =
        topology.MiddleOf(step.triangle, step.exit) - topology.MiddleOf(step.triangle, step.entry);
      for (Eigen::Index j = 0; j < growth.cols(); ++j)
      {
        growth(k, j) += gradient.block<2, 1>(2 * j, step.triangle).dot(along);
      }
    }
  }
  return growth;
}
}

VertexPotential::VertexPotential(SharedTopology topology, const Progress& progress)
  : Operator(WithoutHoles(std::move(topology)))
  , Factor(this->Operator, PotentialFactor::Boundary::Natural, progress)
  , Response(this->Factor)
  , Curvatures(SourcesOfCurvature(this->Operator))
  , Wanted(this->Operator.PeriodCount())
{
  const MeshTopology& mesh = this->GetTopology();
  for (Eigen::Index k = 0; k < this->Wanted.size(); ++k)
  {
    this->Wanted[k] = WantedPhase(mesh, mesh.cycles[k]);
  }
  this->Growth = GrowthOf(this->Operator, this->Response);
}

Eigen::VectorXd VertexPotential::ShiftFor(const std::vector<double>& holonomyDefect) const
{
  if (this->Growth.size() == 0)
  {
    return Eigen::VectorXd::Zero(this->Operator.Rows());
  }
  // A source is φ on the first edge minus φ on the last one, so φ is to grow by the defect less.
  Eigen::VectorXd wanted = Eigen::VectorXd::Zero(this->Growth.rows());
  for (Eigen::Index k = 0; k < wanted.size(); ++k)
  {
    wanted[k] = this->GetTopology().cycles[k].IsClosed() ? -holonomyDefect[k] : 0.0;
  }
  return this->Response.basis * this->Growth.fullPivLu().solve(wanted);
}

VertexPotential::Solution VertexPotential::Solve(const std::vector<int>& quarters) const
{
  const MeshTopology& topology = this->GetTopology();
  const int given = std::accumulate(quarters.begin(), quarters.end(), 0);
  const int required = 4 * topology.edges.EulerCharacteristic(topology.mesh);
  if (given != required)
  {
    throw Error("The quarter indices of singularities and corners add up to " +
      std::to_string(given) + "; this surface needs 4χ = " + std::to_string(required) + ".");
  }
  Eigen::VectorXd sources = this->Curvatures;
  for (int vertex = 0; vertex < topology.VertexCount(); ++vertex)
  {
    sources[vertex] -= 2.0 * Pi * quarters[vertex];
  }
  // Removes the rounding of the angles: sources of a Neumann problem add up to zero.
  sources[0] -= sources.head(topology.VertexCount()).sum();
  constexpr auto All = PotentialOperator::Periods::IslandsAndHoles;
  Solution result;
  result.potential = this->Factor.Solve(sources, All);
  const Eigen::VectorXd carried = this->Response.RemovePeriods(result.potential);
  for (Eigen::Index k = 0; k < carried.size(); ++k)
  {
    result.holonomyDefect.push_back(WrapAngle(this->Wanted[k] - carried[k]));
  }
  result.phaseShift = this->ShiftFor(result.holonomyDefect);
  return result;
}
}
