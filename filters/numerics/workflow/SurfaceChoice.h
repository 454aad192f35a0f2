#pragma once

#include "MeshTopology.h"
#include "Progress.h"
#include "SeamlessMap.h"

#include <vector>

namespace crossfield
{
/// Chooses singularities inside a connected surface with given corners of its boundary: those of SmoothCrosses, at
/// vertices, so that all quarter indices add up to 4χ (docs/method.md §22.11). Those that the crosses have at other places of the
/// boundary go to vertices beside it, those of more than one quarter are divided, and pairs of opposite ones nearer
/// than 0.08 √area along edges are left out. Throws Error as SmoothCrosses does.
std::vector<Cone> ChooseSurfaceCones(
  const MeshTopology& topology, const std::vector<Cone>& corners, const Progress& progress = {});
}
