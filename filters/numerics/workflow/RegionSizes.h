#pragma once

#include "LaidOutRegion.h"
#include "RegionNodes.h"

namespace crossfield
{
/// Returns the target sizes of the region that contains each place.
SizeTargets JoinTargets(const LaidOutRegions& regions);

/// Returns e^H of the singularities of all regions and of their nodes (docs/method.md §21.4), as sizes
/// relative to their mean. Throws Error as SolveHField does.
SizeFunction CommonSizes(const RegionSet& set,
  const std::vector<std::vector<RegionCorner>>& nodeCorners, const LaidOutRegions& regions,
  double meshSize);
}
