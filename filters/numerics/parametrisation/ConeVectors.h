#pragma once

#include "SeamlessMap.h"

namespace crossfield
{
/// Returns the vectors in the map between neighbouring cones of a closed surface, up to quarter turns. Each triangle
/// belongs to the nearest cone, by the distance of its centre in the unfolded map; two cones are neighbours where their
/// triangles share an edge, and a cone is its own neighbour where its triangles close around a handle
/// (docs/method.md §22.4). Vectors between the same cones that agree are returned once. Cost: n log n in triangles.
std::vector<Point> VectorsBetweenCones(const SeamlessMap& map);
}
