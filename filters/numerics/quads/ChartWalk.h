#pragma once

#include "SeamlessMap.h"

namespace crossfield
{
/// A point of the seamless map in the chart of a triangle, with the direction of the first axis of
/// a patch.
struct ChartPlace
{
  int triangle = 0;
  Point w = Point::Zero();
  int rotation = 0; ///< +x of the patch is i^rotation in the chart.
};

/// Returns the end of a straight path from a position, with `displacement` in the axes of the
/// patch. Walks from triangle to triangle, through the side that the path meets first. Stops in the
/// last triangle if the path leaves the domain. Throws Error if it does not end.
ChartPlace WalkStraight(const SeamlessMap& map, ChartPlace place, const Point& displacement);

/// Returns √(area in the domain / area in the map) of a triangle, which is e^H.
double PlaneScale(const SeamlessMap& map, int triangle);
}
