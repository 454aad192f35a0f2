#pragma once

#include "OptimizerStage.h"

#include <optional>

namespace crossfield
{
/// Returns the configuration with one additional pair of opposite signs. Of the best pairs of
/// FindPairs, it is the one that has the minimum of ½ spread² + ¼ Σ δ² after some steps towards
/// uniform sizes, where δ are the holonomy defects. Returns nothing if there is no space for a
/// pair. Throws Aborted.
std::optional<TrackedConfiguration> FindBestPair(const PlanarDomain& domain,
  const OptimizerStage& stage, const OptimizerState& current, const StageOptions& options,
  const Progress& progress);
}
