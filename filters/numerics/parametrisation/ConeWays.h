#pragma once

#include "SeamlessMap.h"

namespace crossfield
{
/// Returns the ways in which cones of a map of a closed surface see their neighbours, as vectors in the map up to quarter
/// turns: from each cone to those whose triangles border on its own, where each triangle belongs to the nearest cone, and to itself where its
/// triangles close around a handle (docs/method.md §22.4). Each way is given once. Cost: n log n in triangles.
std::vector<Point> WaysBetweenCones(const SeamlessMap& map);
}
