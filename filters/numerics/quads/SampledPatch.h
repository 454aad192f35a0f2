#pragma once

#include "TMesh.h"

#include "SeamlessMap.h"

namespace crossfield
{
/// Points of a patch on its surface, for pictures.
struct SampledPatch
{
  int columns = 0;                ///< Cells along side 0.
  int rows = 0;                   ///< Cells along side 1.
  std::vector<SpacePoint> places; ///< (columns + 1) (rows + 1), columns fastest.
  std::vector<Point> positions; ///< In the rectangle of the patch, its first corner as the origin.
};

/// Returns a lattice of cells that are at most `size` long in the map, between 1 and 100 along each side. Its outermost
/// lines are a millionth of a side inside of the patch. Throws Error as WalkStraight does.
SampledPatch SamplePatch(
  const SeamlessMap& map, const TMesh& mesh, const TPatch& patch, double size);
}
