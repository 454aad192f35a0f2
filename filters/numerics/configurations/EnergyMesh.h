#pragma once

#include "DrillHoles.h"

namespace crossfield
{
/// Returns how holes are drilled for energies, so that the gap between their bounds closes at
/// second order in the mesh size h (docs/method.md §5.2). Below the default size h₀, 1/40 of the
/// diagonal D, all triangles shrink in proportion: the growth of the edge length and the edges of
/// holes are h/h₀ times the usual ones, down to a total of 4,096 edges on all holes, for which
/// dense matrices are built. At a corner of angle α > π, where Φ behaves like r^β, β = π/α, edges
/// have the length D (h/D)^{1/β}.
///
/// `meshSize` is that of DrillOptions. Throws Error if it is not a valid size.
DrillOptions DrillForEnergies(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize);
}
