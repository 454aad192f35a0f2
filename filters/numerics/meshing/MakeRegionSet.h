#pragma once

#include "RegionSet.h"

namespace crossfield
{
/// Divides polygons into regions, the connected sets of polygons of one material, and collects the
/// interfaces between them (docs/method.md §21.1). Lines divide regions, or are slits in them (docs/method.md §21.6). Regions
/// do not depend on the order of the polygons. Throws Error if an edge has more than two polygons or one of
/// them on both sides, and if a region touches itself.
RegionSet MakeRegionSet(const MaterialCells& cells);
}
