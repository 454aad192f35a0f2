#pragma once

#include "Progress.h"
#include "SurfaceCones.h"

#include <vector>

namespace crossfield
{
/// Chooses singularities inside a connected surface with given corners of its boundary: those of SmoothCrosses,
/// at vertices, so that all quarter indices add up to 4χ (docs/method.md §22.11). Those that the crosses have at
/// other places of the boundary go to vertices beside it, those of more than one quarter are divided, and pairs
/// of opposite ones nearer than 0.08 √area along edges are left out. Throws Error as SmoothCrosses does, and if
/// the mesh is too coarse.
/// With `withoutPairs` all opposite ones are left out.
std::vector<Cone> ChooseSurfaceCones(const MeshTopology& topology, const std::vector<Cone>& corners,
  bool withoutPairs = false, const Progress& progress = {});

/// Chooses singularities for all faces of a connected part of a surface. Throws Error as PlaceCones and
/// ChooseSurfaceCones do.
std::vector<SurfaceSingularity> ChooseSurfaceSingularities(
  const FeaturedPart& part, const Progress& progress = {});

/// Chooses those of all parts of a surface.
std::vector<SurfaceSingularity> ChooseSurfaceSingularities(
  const SurfaceMesh& surface, double featureAngle, const Progress& progress = {});
}
