#pragma once

#include "LoopArc.h"
#include "MergedCorners.h"

namespace crossfield
{
/// The vertices that a loop has when its sides are made longer between places that stay, at least one, so that neither
/// direction along it is preferred: where a side would be too long or turn too much, it gets the vertex
/// nearest to its middle, or of two as near what is halfway between them.
std::vector<ArcVertex> DivideLoop(const LoopArc& arc, const std::vector<double>& turns,
  const KeptPlaces& kept, const Thinning& thinning);
}
