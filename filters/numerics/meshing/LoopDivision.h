#pragma once

#include "LoopArc.h"
#include "MergedCorners.h"

namespace crossfield
{
/// Returns the vertices of a loop with longer sides between the fixed points. At least one fixed
/// point is required. Neither direction along the loop is preferred: a side that would be too long
/// or turn too much is divided at the vertex closest to its middle or, if two are equally close, at
/// their midpoint.
std::vector<ArcVertex> DivideLoop(const LoopArc& arc, const std::vector<double>& turns,
  const KeptPlaces& kept, const Thinning& thinning);
}
