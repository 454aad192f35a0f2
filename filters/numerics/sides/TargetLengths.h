#pragma once

#include "TMesh.h"
#include "TargetSize.h"

#include <vector>

namespace crossfield
{
/// Returns the length of every arc in units of the target size, for size 1 (docs/method.md §14.8):
/// the length in the map for Conformal, otherwise ∫ ds / h in the plane. Throws Error if h is not
/// positive.
std::vector<double> TargetLengths(const TMesh& mesh, const TargetSizes& sizes);

/// Returns the area of the map, which is the domain's.
double AreaOf(const TMesh& mesh);
}
