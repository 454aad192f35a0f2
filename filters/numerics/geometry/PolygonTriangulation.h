#pragma once

#include "Plane.h"

#include <array>
#include <vector>

namespace crossfield
{
/// Triangulates a counter-clockwise polygon without additional points. Returns counter-clockwise
/// triangles, without degenerate ones, for renderers that draw concave polygons wrongly.
///
/// Ears with the shortest diagonal are clipped first, in O(n²). Points may repeat, as along the
/// slit of a ring that is cut open (vtkContourTriangulator fails there, vtkPolygon omits parts). If
/// rounding leaves no ear, the vertex that turns most to the left is clipped instead; signed areas
/// always add up to that of the polygon, up to rounding.
std::vector<std::array<int, 3>> TriangulatePolygon(const Loop& polygon);
}
