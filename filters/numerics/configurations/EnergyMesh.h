#pragma once

#include "DrillHoles.h"

namespace crossfield
{
/// How holes are drilled for energies, so that the gap between their bounds closes at second order with
/// the mesh size h (docs/method.md §5.2): from the default size h₀, 1/40 of the diagonal D, on all
/// triangles become smaller alike. The growth of the edge length and the lengths of the edges of holes
/// are h/h₀ times the usual ones, down to 4,096 edges on all holes together, of which dense matrices are
/// made. At a corner of angle α > π, where Φ goes like r^β, β = π/α, edges have the length D (h/D)^{1/β}.
///
/// `meshSize` as in DrillOptions. Throws Error when it is not a size.
DrillOptions DrillForEnergies(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize);
}
