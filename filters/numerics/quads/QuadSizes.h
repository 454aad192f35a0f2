#pragma once

#include "QuadMesh.h"
#include "TMesh.h"
#include "TargetSize.h"

namespace crossfield
{
/// Length of every arc in units of the wanted size (docs/method.md §14.8), for size 1: in the map for Conformal,
/// ∫ ds / h in the plane else. Throws Error when h is not positive.
std::vector<double> TargetLengths(const TMesh& mesh, const TargetSizes& sizes);

/// What the points and quads of a mesh want: for Conformal as they are; else squares of size h, with the mean area of
/// its quads.
void WantSizes(QuadMesh& mesh, const TargetSizes& sizes, double area);
}
