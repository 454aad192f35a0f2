#pragma once

#include "BoundaryCorners.h"
#include "Progress.h"
#include "Singularity.h"

namespace crossfield
{
/// Computes the holonomy defect of each inner loop, in (−π, π]: the phase that the single-valued
/// potential of a consistent configuration carries to it minus that of its alignment
/// (docs/method.md §7.3; PointPotential.h). If all are zero, there is an aligned field with |u| = 1
/// and single-valued H.
///
/// Singularities are points, whatever their radii, on the default mesh of MeshForPoints; the
/// defects are those of SolveHField on it. Singularities on the boundary are placed at its vertices
/// (ConfigurationPlacement.h). Without inner loops, the result is empty and nothing is meshed.
/// Throws Error if the configuration is inconsistent, a singularity lies outside, or two are at the
/// same position.
std::vector<double> HolonomyDefects(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& corners = {}, const Progress& progress = {});
}
