#pragma once

#include "QuadMesh.h"
#include "TMesh.h"
#include "TargetSize.h"

namespace crossfield
{
/// Returns the length of every arc in units of the target size, for size 1 (docs/method.md §14.8):
/// the length in the map for Conformal, otherwise ∫ ds / h in the plane. Throws Error if h is not
/// positive.
std::vector<double> TargetLengths(const TMesh& mesh, const TargetSizes& sizes);

/// Sets the target lengths and scales of a mesh: for Conformal they stay as they are; otherwise the
/// targets are squares of size h, scaled so that their total area is `area`.
void SetTargetLengths(QuadMesh& mesh, const TargetSizes& sizes, double area);

/// Sets the target lengths of quads to what they are: the mean of opposite sides, but at least 0.3
/// of the mean of all four.
void SetMeasuredLengths(QuadMesh& mesh);
}
