#pragma once

#include "SeamlessMap.h"

namespace crossfield
{
/// A direction along an axis that leaves a vertex into a triangle.
struct Departure
{
  int triangle = 0;
  int corner = 0;    ///< Of the triangle, where the vertex is.
  int direction = 0; ///< i^direction in the chart of the triangle.
};

/// All directions along axes that leave the cones of a map into the domain, per cone in
/// counter-clockwise order: 4 − k of them inside, and at a corner the 1 − k between its two sides
/// (docs/method.md §13.1). The fan of triangles is developed once, in eighths of a turn as whole numbers, so that none is
/// lost or found twice. Throws Error when the triangles around a vertex do not make up its angle.
std::vector<std::vector<Departure>> FindDepartures(const SeamlessMap& map);
}
