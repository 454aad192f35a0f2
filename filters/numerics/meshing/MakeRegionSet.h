#pragma once

#include "RegionSet.h"

namespace crossfield
{
/// Divides polygons into regions, the connected sets of polygons of one material, and collects the
/// interfaces between them (docs/method.md §21.1). Lines divide regions, or are slits in them
/// (docs/method.md §21.6). Regions do not depend on the order of the polygons. Throws Error as CellSides
/// does, and if a region touches itself.
RegionSet MakeRegionSet(const MaterialCells& cells);

/// Sets the names of interfaces to those of their sides, with a number if there are several of one name.
void NumberInterfaces(RegionSet& set);
}
