#pragma once

#include "BoundaryCorners.h"
#include "Progress.h"
#include "Singularity.h"

namespace crossfield
{
/// Per inner loop, in (−π, π]: the phase that the single-valued potential of a consistent
/// configuration carries to it minus that of its alignment (docs/method.md §7.3; PointPotential.h). Zero on
/// all loops: there is an aligned field with |u| = 1 and single-valued H.
///
/// That of points, whatever their radii, on the mesh that MeshForPoints makes by default: the defects of
/// SolveHField there. Singularities at the boundary are those of their vertices (ConfigurationPlacement.h).
/// Empty without inner loops, and then nothing is meshed. Throws Error when the configuration is
/// inconsistent, a singularity lies outside, or two are at one place.
std::vector<double> HolonomyDefects(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& corners = {}, const Progress& progress = {});
}
