#pragma once

#include "BoundaryCorners.h"
#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// Returns the domain with an additional vertex at each singularity on its boundary, within 1e-6 of
/// the diagonal.
PlanarDomain InsertBoundarySingularities(
  const PlanarDomain& domain, const Configuration& configuration);

/// Returns whether a point is on the boundary, within 1e-6 of the diagonal.
bool IsOnBoundary(const PlanarDomain& domain, const Point& place);

/// Returns the singularities on the boundary as prescribed quarter indices of the vertices that
/// InsertBoundarySingularities creates. They replace the corner's own index there.
std::vector<CornerChoice> BoundaryChoices(
  const PlanarDomain& domain, const Configuration& configuration);
}
