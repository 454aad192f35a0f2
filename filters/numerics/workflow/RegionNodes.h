#pragma once

#include "BoundaryCorners.h"
#include "RegionSet.h"

namespace crossfield
{
/// The corner of a region at a node of regions, with its quarter index.
struct RegionCorner
{
  std::size_t region = 0;
  Corner corner;
  int quarterIndex = 0;
};

/// Returns for each node of a set the corners of the regions that meet there. Their quarter indices are
/// chosen together (ChooseNodeIndices) but for those in `given`, which holds prescribed ones per region.
std::vector<std::vector<RegionCorner>> FindNodeCorners(
  const RegionSet& set, const std::vector<std::vector<CornerChoice>>& given);

/// Returns the quarter index of a node in the mesh of all regions (IndexOfNode).
int IndexAt(const RegionNode& node, const std::vector<RegionCorner>& corners);
}
