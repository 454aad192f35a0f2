#pragma once

#include "BoundarySides.h"
#include "RegionSet.h"

namespace crossfield
{
/// Returns what messages call a region: its material, if there are several, and a point of it.
std::string DescribeRegion(const RegionSet& set, std::size_t region);

/// Calls pieces of interfaces by the names that are given for all their segments, per region as for
/// NameSides; with a number if there are several of one name.
void UseGivenNames(const std::vector<SegmentNames>& ofRegions, RegionSet& set);

/// Returns the sides of a region: pieces of interfaces with their names, and the other segments with
/// given names, or generated ones as NameSides has them. `names` and `taken`: as for NameSides. Sides
/// of interfaces begin and end at nodes of the mesh.
BoundarySides SidesOfRegion(const RegionSet& set, std::size_t region, SegmentNames names = {},
  const std::vector<std::string>& taken = {});
}
