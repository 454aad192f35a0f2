#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

namespace crossfield
{
/// The domain with a vertex wherever a singularity lies on its boundary, within 1e-6 of the diagonal.
PlanarDomain InsertBoundarySingularities(
  const PlanarDomain& domain, const Configuration& configuration);
}
