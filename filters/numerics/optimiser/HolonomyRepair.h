#pragma once

#include "BoundaryCorners.h"
#include "PlanarDomain.h"
#include "Progress.h"
#include "Singularity.h"

namespace crossfield
{
/// Singularities that were moved to positions at which no inner loop has a holonomy defect.
struct HolonomyRepair
{
  Configuration singularities; ///< In the order given.
  double largestMove = 0.0;    ///< Maximum displacement of a singularity, a length.
  std::vector<double> before;  ///< Holonomy defects at the start (see HolonomyDefects).
  std::vector<double> after;   ///< Holonomy defects afterwards on the same mesh, at most 1e-9.
  int steps = 0;               ///< Number of Newton steps.
};

/// Moves the interior singularities to the closest positions, in the sum of squares, at which all
/// holonomy defects vanish (docs/method.md §7.4). The steps are the shortest Newton steps −J⁺ d,
/// where J contains the derivatives of the defects d; corrections then minimise the distance from
/// the start. One mesh is used, of size `meshSize`; 0 stands for the default size, which resolves
/// the singularities.
///
/// Singularities on the boundary are not moved. Throws Error with the inner loop and the angle if
/// its defect cannot be changed by moving singularities, or if no such positions are found; throws
/// Error as HolonomyDefects does if the configuration is inconsistent.
HolonomyRepair RepairHolonomy(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& corners = {}, double meshSize = 0.0,
  const Progress& progress = {});
}
