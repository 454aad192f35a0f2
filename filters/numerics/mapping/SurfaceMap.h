#pragma once

#include "Progress.h"
#include "SeamlessMap.h"

namespace crossfield
{
/// Solves for the seamless map of a surface whose singularities and corners are cones at its vertices
/// (docs/method.md §22.3). A closed surface has a free angle: crosses are along the first side of its first
/// triangle there.
///
/// Throws Error when the quarter indices do not add up to 4χ, when a cone has no angle in a map (indices
/// above 2 inside, above 1 on the boundary), when crosses do not close up around a handle, and when the map
/// folds over, with a place.
SeamlessMap SolveSurfaceMap(
  const SharedTopology& topology, const std::vector<Cone>& cones, const Progress& progress = {});
}
