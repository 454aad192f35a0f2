#pragma once

#include "PartRequests.h"
#include "RegionNodes.h"
#include "RegionSet.h"

namespace crossfield
{
/// What a request means for the regions of a set.
struct RegionRequests
{
  std::vector<PartRequest> ofRegions;
  std::vector<std::vector<RegionCorner>> nodeCorners; ///< Per node of the set.
  /// Names of the pieces of interfaces whose size is that inside of a material: a target, but no number of edges.
  std::vector<std::string> targets;
};

/// Opens the interfaces with these names, those of their materials in either order, or given ones. Throws
/// Error for a name that none has.
void OpenInterfaces(const std::vector<std::string>& names, RegionSet& set);

/// Divides a request for regions as SplitRequest does. The indices of corners at nodes are chosen for all
/// regions together (FindNodeCorners), and given to the regions as prescribed ones. What it prescribes for
/// an interface, by the names of its materials in either order or a given one, is prescribed for each of
/// its pieces in both regions. A size inside of a material is that of its regions, and of the interfaces of
/// others with them that have a larger size or none; without another size or number, the size elsewhere is
/// then that of DefaultQuads quads.
/// Throws Error as SplitRequest does.
RegionRequests SplitForRegions(
  const RegionSet& set, const std::vector<DomainPart>& parts, const QuadRequest& request);
}
