#pragma once

#include "OptimizerStage.h"

#include <optional>

namespace crossfield
{
/// The configuration with one pair of opposite signs more: of the best ones of FindPairs that which after some
/// steps for even sizes has the least ½ spread² + ¼ Σ δ² of the holonomy defects. Nothing where there is no room.
/// Throws Aborted.
std::optional<TrackedConfiguration> FindBestPair(const PlanarDomain& domain,
  const OptimizerStage& stage, const OptimizerPlace& here, const StageOptions& options,
  const Progress& progress);
}
