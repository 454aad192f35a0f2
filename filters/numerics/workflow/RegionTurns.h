#pragma once

#include "BoundarySymmetry.h"
#include "Singularity.h"

namespace crossfield
{
/// Returns the rotation of singularities about a centre with which −Σ k_i k_j log |x_i − x_j| over them and
/// others is lowest (docs/method.md §21.2); the identity if none is lower by more than rounding.
Isometry LowestTurn(const Configuration& own, const Configuration& others, const Point& centre);
}
