#pragma once

#include "Progress.h"
#include "SeamlessMap.h"

namespace crossfield
{
/// Solves for the seamless map of a surface whose singularities and corners are cones at its vertices
/// (docs/method.md §22.3). The map of a closed surface without any has one cone of index 0, where its lines
/// start. If it folds, the flat metric with these cones is laid out instead (docs/method.md §22.9), and the map is one of another
/// triangulation of the surface.
///
/// Throws Error when the quarter indices do not add up to 4χ, when a cone has no angle in a map (indices
/// above 2 inside, above 1 on the boundary), and, with a place, when the map folds over.
SeamlessMap SolveSurfaceMap(
  const SharedTopology& topology, const std::vector<Cone>& cones, const Progress& progress = {});
}
