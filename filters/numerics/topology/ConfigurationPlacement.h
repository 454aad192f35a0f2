#pragma once

#include "BoundaryCorners.h"
#include "PlanarTopology.h"
#include "Singularity.h"

namespace crossfield
{
/// A configuration divided into interior singularities and corners.
struct PlacedConfiguration
{
  Configuration interior;
  std::vector<std::size_t> rows; ///< Rows of the interior singularities in the given configuration.
  std::vector<CornerChoice>
    corners; ///< The given corners, followed by those of the cheapest assignment if it is used.
};

/// Separates singularities at vertices of outer and inner loops, within 1e-6 of the diagonal, from
/// those inside, and completes the corners; see SolveHField. A singularity at a corner replaces the
/// choice for it in `corners`; the optimiser creates such singularities.
PlacedConfiguration PlaceConfiguration(const PlanarTopology& topology,
  const Configuration& configuration, const std::vector<CornerChoice>& corners);
}
