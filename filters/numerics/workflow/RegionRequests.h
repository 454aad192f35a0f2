#pragma once

#include "PartRequests.h"
#include "RegionSet.h"

namespace crossfield
{
/// Divides a request for regions as SplitRequest does. What it prescribes for an interface, by the names of
/// its materials in either order or a given one, is prescribed for each of its pieces in both regions. A
/// size inside of a material is that of its regions, and of the interfaces of others with them; without
/// another size or number, the size elsewhere is then that of DefaultQuads quads. Throws Error as
/// SplitRequest does.
std::vector<PartRequest> SplitForRegions(
  const RegionSet& set, const std::vector<DomainPart>& parts, const QuadRequest& request);
}
