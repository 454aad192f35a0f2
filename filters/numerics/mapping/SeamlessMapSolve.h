#pragma once

#include "BoundaryCorners.h"
#include "ConfigurationPlacement.h"
#include "PotentialSolver.h"
#include "Progress.h"
#include "SeamlessMap.h"
#include "Singularity.h"

#include <memory>

namespace crossfield
{
struct SeamlessMapOptions
{
  std::vector<CornerChoice> corners; ///< As for SolveHField.
  /// Applies CapCorners of PoincareHopf.h; the quarters that this removes from corners must be
  /// among the singularities.
  bool capCorners = false;
};

/// Calls PlaceConfiguration with the corners of the options, capped if the options say so.
PlacedConfiguration PlaceForMap(const PlanarTopology& topology, const Configuration& configuration,
  const SeamlessMapOptions& options);

/// Solves for the seamless map on a mesh with a vertex at every singularity (MeshThroughPoints).
/// Needs one factorisation for H, unless the solver of this mesh is given, and one for w.
///
/// Throws Error when a singularity has quarter index 3 or more or is at no vertex, when a corner
/// has index 2 or more, when the configuration is not consistent, and, with the location, when the
/// map folds over or the angles at a vertex do not add up.
SeamlessMap SolveSeamlessMap(const SharedPlanarTopology& topology,
  const Configuration& configuration, const SeamlessMapOptions& options = {},
  const Progress& progress = {}, const std::shared_ptr<const PotentialSolver>& potential = nullptr);
}
