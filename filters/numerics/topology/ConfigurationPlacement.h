#pragma once

#include "BoundaryCorners.h"
#include "MeshTopology.h"
#include "Singularity.h"

namespace crossfield
{
/// What SolveHField makes of a configuration.
struct PlacedConfiguration
{
  Configuration interior;
  std::vector<std::size_t> rows; ///< Of the interior ones in the configuration.
  std::vector<CornerChoice>
    corners; ///< Given ones, then those of the cheapest assignment, if used.
};

/// Tells singularities at vertices of outer and inner loops, within 1e-6 of the diagonal, from those
/// inside, and completes the corners; see SolveHField. A singularity at a corner replaces a choice for it
/// in `corners`: the optimiser makes such singularities.
PlacedConfiguration PlaceConfiguration(const MeshTopology& topology,
  const Configuration& configuration, const std::vector<CornerChoice>& corners);
}
