#pragma once

#include "PartRequests.h"
#include "Progress.h"
#include "RegionSet.h"

namespace crossfield
{
/// Makes one conforming quad mesh of regions (docs/method.md §21): singularities and layouts of each
/// region by itself, edge counts of all of them together, one smoothing in which nodes slide along
/// interfaces. `parts` are the regions with their sides (SidesOfRegion) and curves. Without requested
/// sizes, the target sizes are e^H of one potential of all regions.
///
/// Throws Error as MakeQuadMesh does, with the name of the material, and where the request has what is
/// not available for several regions.
QuadWorkflowResult MakeQuadsOfRegions(const RegionSet& set, const std::vector<DomainPart>& parts,
  const QuadRequest& request, const Progress& progress = {});
}
