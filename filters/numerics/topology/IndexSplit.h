#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"

#include <string>
#include <vector>

namespace crossfield
{
/// A configuration without interior quarter indices of 2 and more.
struct SplitConfiguration
{
  Configuration singularities;
  std::vector<std::string> events; ///< One sentence per singularity that was split.
};

/// Replaces every interior singularity with |k| ≥ 2 by |k| singularities of quarter index ±1, the
/// sign of k: nodes of valence 3 or 5 instead of one of valence 4 − k. They form a regular polygon
/// around its position with sides of length `distance`, shorter where the boundary or another
/// singularity is near. Two are placed across the direction to whatever is nearest. The order is
/// kept.
SplitConfiguration SplitIndices(
  const PlanarDomain& domain, const Configuration& configuration, double distance);
}
