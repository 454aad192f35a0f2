#pragma once

#include "QuadMesh.h"
#include "SidePrescription.h"

namespace crossfield
{
/// Moves the points of graded sides and of sides with a prescribed size to their final positions,
/// from one corner or end of the side to the next, and fixes them. The lengths of graded edges
/// become the targets of all quads in their strips (chords): along a strip the target lengths keep
/// their variation and are multiplied by one factor or, if both ends are graded, by a geometric
/// mean of two. Points inside follow; `hold`: those of singularities stay.
void PlaceOnSides(
  const BoundaryCurves& curves, const SidePrescriptions& prescribed, bool hold, QuadMesh& mesh);
}
