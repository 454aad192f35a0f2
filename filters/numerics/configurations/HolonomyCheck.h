#pragma once

#include "BoundaryCorners.h"
#include "Progress.h"
#include "Singularity.h"

namespace crossfield
{
/// Per inner loop, in (−π, π]: the phase that the single-valued potential of a consistent
/// configuration carries to it minus that of its alignment (docs/method.md §7.3; UnitNormField.h). Zero on
/// all loops: there is an aligned field with |u| = 1 and single-valued H.
///
/// Drills the configuration with the default mesh size; singularities without a radius get one that
/// fits. Empty without inner loops, and then nothing is drilled. Throws Error when the
/// configuration is inconsistent or cannot be drilled.
std::vector<double> HolonomyDefects(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& corners = {}, const Progress& progress = {});
}
