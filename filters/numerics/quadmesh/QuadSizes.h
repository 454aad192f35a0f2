#pragma once

#include "QuadMesh.h"
#include "TargetSize.h"

namespace crossfield
{
/// Sets the target lengths and scales of a mesh: for Conformal they stay as they are; otherwise the
/// targets are squares of size h, scaled so that their total area is `area`.
void SetTargetLengths(QuadMesh& mesh, const TargetSizes& sizes, double area);

/// Sets the target lengths of quads to what they are: the mean of opposite sides, but at least 0.3
/// of the mean of all four.
void SetMeasuredLengths(QuadMesh& mesh);
}
