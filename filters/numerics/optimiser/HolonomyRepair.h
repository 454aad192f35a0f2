#pragma once

#include "BoundaryCorners.h"
#include "PlanarDomain.h"
#include "Progress.h"
#include "Singularity.h"

namespace crossfield
{
/// Singularities that were moved to where no inner loop has a holonomy defect.
struct HolonomyRepair
{
  Configuration singularities; ///< In the order given.
  double largestMove = 0.0;    ///< The longest way of one, a length.
  std::vector<double> before;  ///< Holonomy defects, as of HolonomyDefects,
  std::vector<double> after;   ///< on the same mesh: at most 1e-9.
  int steps = 0;
};

/// Moves the singularities inside the least way, in the sum of squares, to where all holonomy defects vanish
/// (docs/method.md §7.4): the shortest steps −J⁺ d of Newton's method, J the derivatives of the defects d, each
/// taken from the start on. On one mesh of size `meshSize`, 0: the default, which resolves them.
///
/// Those on the boundary stay. Throws Error that names the inner loop and the angle when its defect cannot be
/// changed by moving singularities, or when no such place is found; as HolonomyDefects when the configuration is
/// inconsistent.
HolonomyRepair RepairHolonomy(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& corners = {}, double meshSize = 0.0,
  const Progress& progress = {});
}
