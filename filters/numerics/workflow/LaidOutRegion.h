#pragma once

#include "PartRequests.h"
#include "QuadSteps.h"

#include <deque>
#include <optional>

namespace crossfield
{
/// A region up to its layout.
struct LaidOutRegion
{
  PlanarDomain domain; ///< With curves sampled.
  ResolvedRequest request;
  std::optional<QuadSteps> placed; ///< With singularities, before the layout; refers to `domain`.
  QuadWorkflowResult result;
  Layout layout;
};

/// Regions; steps refer to their domains, which do not move.
using LaidOutRegions = std::deque<LaidOutRegion>;

/// Samples the curves of a region and chooses its singularities unless they are given. `seconds` receives
/// the times of its steps. Throws Error as QuadSteps::Place does.
void PlaceSingularities(const PlanarDomain& polygons, const QuadRequest& request,
  QuadSeconds& seconds, const Progress& progress, LaidOutRegion& region);

/// Lays out a region with its singularities, on a finer mesh or with the holonomy repaired if it fails
/// otherwise. Throws Error as QuadSteps::LayOutOnly does.
void LayOutRegion(const Progress& progress, LaidOutRegion& region);
}
