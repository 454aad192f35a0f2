#pragma once

#include "BoundaryCorners.h"
#include "ConfigurationPlacement.h"
#include "SeamlessMap.h"
#include "Progress.h"
#include "Singularity.h"

namespace crossfield
{
struct SeamlessMapOptions
{
  std::vector<CornerChoice> corners; ///< As for SolveHField.
  /// CapCorners of PoincareHopf.h; what is missing must be among the singularities.
  bool capCorners = false;
};

/// PlaceConfiguration with the corners that the options ask for.
PlacedConfiguration PlaceForMap(
  const MeshTopology& topology, const Configuration& configuration, const SeamlessMapOptions& options);

/// Solves for the map on a mesh with a vertex at every singularity (MeshOnPoints): one factorisation
/// for H, one for w.
///
/// Throws Error when a singularity is of quarter index 3 or more or at no vertex, when a corner is of
/// index 2 or more, when the configuration is not consistent, and, with the place, when the map folds over
/// or the angles at a vertex do not add up.
SeamlessMap SolveSeamlessMap(const SharedTopology& topology, const Configuration& configuration,
  const SeamlessMapOptions& options = {}, const Progress& progress = {});
}
