#pragma once

#include "SeamlessMap.h"

namespace crossfield
{
/// A straight way from a cone of a map to another one or to itself.
struct ConeWay
{
  Point vector;       ///< In the chart of a triangle at the cone where it starts.
  double share = 1.0; ///< ½ if it leads through vertices, and is found on both sides of them.
};

/// Returns straight ways from cones of a map of a closed surface to the nearest ones: those up to 1.5 times as long as
/// needed for as many ways as cones. Ways are found by unfolding the triangles that are seen from a cone, the nearest first. Cost: n log n in
/// these triangles, of which 30 per triangle of the surface are visited at most.
std::vector<ConeWay> WaysBetweenCones(const SeamlessMap& map);
}
