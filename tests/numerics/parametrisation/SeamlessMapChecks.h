#pragma once

#include "SeamlessMap.h"

namespace crossfield::test
{
/// Returns the largest deviation from the equations of seams and boundary sides, relative to the
/// extent.
double SeamDefect(const SeamlessMap& map);

/// Returns the largest deviation of an angle sum of the map from that of its cones, radians.
double AngleSumDefect(const SeamlessMap& map);

/// Returns the length of the shortest edge in the map, relative to the extent.
double ShortestEdge(const SeamlessMap& map);

/// Returns the number of triangles that are not positive in the map, or not in the plane.
int CountReversed(const SeamlessMap& map);
}
