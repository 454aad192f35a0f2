#pragma once

#include "Plane.h"

#include <array>
#include <vector>

namespace crossfield
{
/// Divides a polygon, counter-clockwise, into triangles of its own points, counter-clockwise, without
/// those of no area: what a renderer needs, which draws concave polygons wrongly. Ears with the shortest
/// diagonal are cut off first, in O(n²). Points may repeat, as along the slit of a ring that is cut
/// open (vtkContourTriangulator gives up there, vtkPolygon leaves parts out).
///
/// Where rounding leaves no ear the vertex that turns most to the left is taken all the same: signed
/// areas always add up to that of the polygon, to rounding.
std::vector<std::array<int, 3>> TriangulatePolygon(const Loop& polygon);
}
