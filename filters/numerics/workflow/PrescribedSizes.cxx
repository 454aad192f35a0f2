#include "PrescribedSizes.h"

#include "MeshForPoints.h"
#include "P1Interpolation.h"
#include "SizeExtension.h"

#include <memory>
#include <utility>

namespace crossfield
{
Eigen::VectorXd SampleSizes(const PrescribedSizes& sizes, const PlanarTopology& topology)
{
  const TriangleMesh& mesh = topology.mesh;
  Eigen::VectorXd lengths(static_cast<Eigen::Index>(mesh.points.size()));
  if (sizes.isOnBoundaryOnly)
  {
    for (const BoundaryEdge& edge : mesh.boundary)
    {
      const int vertex = edge.vertices[0];
      lengths[vertex] = sizes.length(topology.PointAt(vertex));
    }
    return ExtendSizes(topology, lengths);
  }
  for (Eigen::Index v = 0; v < lengths.size(); ++v)
  {
    lengths[v] = sizes.length(mesh.points[v]);
  }
  return lengths;
}

RelativeSizes ComputeRelativeSizes(const PrescribedSizes& sizes, const PlanarTopology& topology)
{
  const TriangleMesh& mesh = topology.mesh;
  Eigen::VectorXd lengths = SampleSizes(sizes, topology);
  RelativeSizes result;
  result.mean = EquivalentSize(mesh, lengths);
  lengths /= result.mean;
  const auto relative = std::make_shared<const P1Interpolation>(mesh, std::move(lengths));
  result.field = [relative](const Point& place) { return relative->At(place); };
  return result;
}

RelativeSizes RelativeTo(const SizeTargets& targets)
{
  return { [length = targets.length, mean = targets.mean](const Point& place)
    { return length(place) / mean; },
    targets.mean };
}

RelativeSizes ComputeRelativeSizes(
  const PrescribedSizes& sizes, const PlanarDomain& domain, double meshSize)
{
  return ComputeRelativeSizes(sizes, *ShareTopology(MeshThroughPoints(domain, {}, meshSize)));
}
}
