#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// Returns the length from one position to the next along a loop of length `loop`, between −0.2 and
/// 0.8 of it: few edges may share a loop, and positions may be in the wrong order, but not by much.
double LengthAlong(const CurvePlace& from, const CurvePlace& to, double loop);

/// Moves the points of boundary edges that run backwards, which can happen where arcs of the T-mesh
/// have no edge: between two fixed points, positions are the mean of those given and of equidistant
/// ones, with as little of the latter as it takes. Points in the right order do not move.
void OrderOnBoundary(QuadMesh& mesh, const BoundaryCurves& curves);
}
