#pragma once

#include "QuadBand.h"

namespace crossfield
{
/// Replaces the rows of a band by other rows (docs/method.md §16.2). `lines` has, per grid line
/// across the band, its new inner points from the wall inwards, as many on each line; those on the
/// boundary have a position on it. The points at the wall and behind the band remain, and so do all
/// others. New quads have their measured lengths as target lengths.
void DivideBand(LayeredMesh& layered, const QuadBand& band, const QuadWalk& walk,
  const std::vector<std::vector<QuadPoint>>& lines);
}
