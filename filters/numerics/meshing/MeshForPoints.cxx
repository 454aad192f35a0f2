#include "MeshForPoints.h"

#include "BoundaryCorners.h"
#include "BoundarySingularities.h"
#include "DomainQueries.h"
#include "DrillHoles.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
TriangleMesh MeshForPoints(const PlanarDomain& domain, const Configuration& configuration,
  double meshSize, const Progress& progress)
{
  DrillOptions options;
  options.meshSize = meshSize;
  const double size = ResolveMeshSize(options, domain);
  for (const Singularity& singularity : configuration)
  {
    if (!singularity.position.allFinite())
    {
      continue; // SolveHField refuses it
    }
    double room = std::abs(SignedDistance(singularity.position, domain));
    room = room <= BoundaryReach * domain.Diagonal() ? size : std::min(room, size);
    for (const Singularity& other : configuration)
    {
      const double apart = (other.position - singularity.position).norm();
      room = apart > 0.0 ? std::min(room, apart) : room;
    }
    // A thousandth is fine enough for any picture, and bounds the number of triangles.
    options.refinements.push_back({ singularity.position, std::max(0.25 * room, 1e-3 * size) });
  }
  return DrillHoles(InsertBoundarySingularities(domain, configuration), {}, options, progress);
}
}
