#pragma once

#include "CellSides.h"

#include <string>

namespace crossfield
{
/// Returns the polygons of the loops of a region, with its slits open (docs/method.md §21.6): sides whose twins are
/// in the loops as well. Throws Error that names `what` if the loops touch at a point that is on no slit.
std::vector<Loop> OpenPolygons(
  const CellSides& sides, const std::vector<SideLoop>& loops, const std::string& what);
}
