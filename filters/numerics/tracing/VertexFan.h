#pragma once

#include "SeamlessMap.h"

namespace crossfield
{
/// An axis-parallel direction from a vertex into a triangle.
struct Departure
{
  int triangle = 0;
  int corner = 0;    ///< Corner of the triangle at the vertex.
  int direction = 0; ///< Direction i^direction in the chart of the triangle.
};

/// Finds all axis-parallel directions from the cones of a map into the domain, per cone in
/// counter-clockwise order: 4 − k inside, and at a corner the 1 − k between its two sides
/// (docs/method.md §13.1). The fan of triangles is unfolded once, with angles as integral eighths
/// of a turn, so that no direction is lost or found twice. Throws Error when the triangles around a
/// vertex do not add up to its angle.
std::vector<std::vector<Departure>> FindDepartures(const SeamlessMap& map);
}
