#pragma once

#include "MeshTopology.h"

namespace crossfield
{
/// The mesh with a vertex on every point, changed only around them (docs/method.md §15.1): the nearest vertex moves to the point
/// where that leaves its triangles well shaped, else the point is inserted; then edges are flipped until they are Delaunay.
/// Boundary and numbering of the other vertices stay. The cost is that of a copy.
///
/// Points must keep an edge's length from the boundary and from each other. Throws Error when one lies outside.
TriangleMesh InsertPoints(const MeshTopology& topology, const std::vector<Point>& points);
}
