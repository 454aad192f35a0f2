#include "FactoredDomain.h"

#include "BoundarySingularities.h"
#include "DomainQueries.h"
#include "DrillHoles.h"
#include "MeshForPoints.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
DrillOptions OptionsOfSize(double meshSize)
{
  DrillOptions options;
  options.meshSize = meshSize;
  return options;
}

std::unique_ptr<const BaseTriangulation> Triangulate(const PlanarTopology& topology)
{
  std::vector<bool> onBoundary(topology.mesh.points.size(), false);
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    onBoundary[edge.vertices[0]] = true;
  }
  std::vector<Point> inside;
  for (std::size_t v = 0; v < onBoundary.size(); ++v)
  {
    if (!onBoundary[v])
    {
      inside.push_back(topology.mesh.points[v]);
    }
  }
  std::vector<BoundaryEdge> marks;
  for (const BoundaryLoop& loop : topology.loops)
  {
    marks.push_back({ { 0, 0 }, loop.kind, loop.id, loop.quarterIndex });
  }
  return std::make_unique<const BaseTriangulation>(
    PlanarDomain{ topology.AlignedLoops() }, marks, inside);
}
}

FactoredDomain::FactoredDomain(PlanarDomain domain, const Configuration& configuration,
  double meshSize, const Progress& progress)
  : Domain(std::move(domain))
  , MeshSize(ResolveMeshSize(OptionsOfSize(meshSize), this->Domain))
  , Potential(std::make_shared<const PotentialSolver>(
      ShareTopology(DrillHoles(InsertBoundarySingularities(this->Domain, configuration), {},
        OptionsOfSize(meshSize), progress.Part(0.0, 0.5))),
      progress.Part(0.5, 1.0)))
{
}

bool FactoredDomain::HasBoundaryVertices(const Configuration& configuration) const
{
  const double tolerance = BoundaryReach * this->Domain.Diagonal();
  const std::vector<Loop> loops = this->Potential->GetTopology().AlignedLoops();
  return std::all_of(configuration.begin(), configuration.end(),
    [&](const Singularity& singularity)
    {
      return !singularity.position.allFinite() ||
        !IsOnBoundary(this->Domain, singularity.position) ||
        std::any_of(loops.begin(), loops.end(),
          [&](const Loop& loop)
          {
            return std::any_of(loop.begin(), loop.end(),
              [&](const Point& vertex)
              { return (vertex - singularity.position).norm() <= tolerance; });
          });
    });
}

TriangleMesh FactoredDomain::MeshOn(const Configuration& configuration) const
{
  const double clearance = 2.0 * this->MeshSize;
  std::vector<Point> inside;
  for (const Singularity& singularity : configuration)
  {
    if (singularity.position.allFinite() && IsOnBoundary(this->Domain, singularity.position))
    {
      continue;
    }
    const bool isClear = singularity.position.allFinite() &&
      SignedDistance(singularity.position, this->Domain) >= clearance &&
      std::all_of(inside.begin(), inside.end(),
        [&](const Point& other) { return (other - singularity.position).norm() >= clearance; });
    if (!isClear)
    {
      return MeshThroughPoints(this->Domain, configuration, this->MeshSize);
    }
    inside.push_back(singularity.position);
  }
  std::call_once(this->IsTriangulated,
    [this] { this->Triangulation = Triangulate(this->Potential->GetTopology()); });
  // Vertices closer than a third of the edge length are removed, since they would leave edges much
  // shorter than those around.
  return this->Triangulation->With(inside, this->MeshSize / 3.0);
}
}
