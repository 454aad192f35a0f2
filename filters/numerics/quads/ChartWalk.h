#pragma once

#include "SeamlessMap.h"

namespace crossfield
{
/// A point of the flat surface, with the chart's direction of a rectangle's first axis.
struct ChartPlace
{
  int triangle = 0;
  Point w = Point::Zero();
  int rotation = 0; ///< The rectangle's +x is i^rotation in the chart.
};

/// The end of a straight way that starts at a place, in the axes of its rectangle: from triangle to triangle, each
/// left through the side that the way meets first. Ends at the boundary at the latest.
ChartPlace WalkStraight(const SeamlessMap& map, ChartPlace place, const Point& way);

/// The point of the plane at a place.
Point PlanePoint(const SeamlessMap& map, const ChartPlace& place);

/// √(area in the plane / area in the map) of a triangle: e^H in it.
double PlaneScale(const SeamlessMap& map, int triangle);
}
