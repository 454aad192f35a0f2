#pragma once

#include "SurfaceMesh.h"

namespace crossfield
{
/// Returns the same surface with triangles whose sides are at most as long as given (docs/method.md §22.11):
/// longer sides are divided at their midpoints, the longest first; in planes, up to 1e-6 of the diagonal,
/// diagonals are those of Delaunay triangulations. Regions and lines stay. The surface is an oriented manifold; its points come first.
SurfaceMesh Refined(SurfaceMesh surface, double length);
}
