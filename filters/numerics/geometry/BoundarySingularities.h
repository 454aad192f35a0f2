#pragma once

#include "BoundaryCorners.h"
#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// The domain with a vertex wherever a singularity lies on its boundary, within 1e-6 of the diagonal.
PlanarDomain InsertBoundarySingularities(
  const PlanarDomain& domain, const Configuration& configuration);

/// Whether a place is on the boundary, within 1e-6 of the diagonal.
bool IsOnBoundary(const PlanarDomain& domain, const Point& place);

/// The singularities on the boundary as chosen quarter indices of the vertices that
/// InsertBoundarySingularities makes: there they take the place of the corner's own index.
std::vector<CornerChoice> BoundaryChoices(
  const PlanarDomain& domain, const Configuration& configuration);
}
