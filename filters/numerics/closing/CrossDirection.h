#pragma once

#include "SeamlessMap.h"

namespace crossfield
{
/// Returns the angles of the crosses of a map at points of its domain: of the directions in which u
/// grows.
std::vector<double> CrossAnglesAt(const SeamlessMap& map, const std::vector<Point>& places);
}
