#include "Alignment.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
Alignment AlignWithBoundary(
  const PlanarTopology& topology, const std::vector<CornerChoice>& corners, int pointQuarters)
{
  Alignment alignment;
  alignment.corners = corners;
  alignment.count = CountMeshQuarters(topology, corners);
  alignment.count.givenInteriorQuarters += pointQuarters;
  for (const CountedCorner& corner : alignment.count.corners)
  {
    if (corner.chosen)
    {
      alignment.chosenQuarters[topology.VertexOf(corner)] = corner.quarterIndex;
    }
  }
  const auto& boundary = topology.mesh.boundary;
  alignment.crosses = ComplexVector::Zero(static_cast<Eigen::Index>(boundary.size()));
  for (std::size_t i = 0; i < boundary.size(); ++i)
  {
    if (boundary[i].IsAligned())
    {
      alignment.crosses[static_cast<Eigen::Index>(i)] = AlignedRepresentation(
        topology.PointAt(boundary[i].vertices[1]) - topology.PointAt(boundary[i].vertices[0]));
    }
  }
  return alignment;
}

double SetAlignedCrosses(
  const PlanarTopology& topology, const Alignment& alignment, ComplexVector& u)
{
  double change = 0.0;
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    if (topology.mesh.boundary[i].IsAligned())
    {
      Complex& value = u[topology.edges.ofBoundary[i]];
      const Complex prescribed = alignment.crosses[static_cast<Eigen::Index>(i)];
      change = std::max(change, std::abs(value - prescribed));
      value = prescribed;
    }
  }
  return change;
}

PotentialProblem::PotentialProblem(
  std::shared_ptr<const PotentialSolver> solver, Alignment boundaryCondition)
  : potential(std::move(solver))
  , alignment(std::move(boundaryCondition))
{
  RequireConsistent(this->alignment.count);
}
}
