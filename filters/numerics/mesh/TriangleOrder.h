#pragma once

#include "TriangleMesh.h"

namespace crossfield
{
/// The same mesh with its triangles in the order in which Hilbert's curve through the box of the mesh passes their
/// centroids, and its points numbered as these triangles use them first; points without triangles come last.
/// Neighbours are then near to each other in memory and in files, where zlib finds the values of an edge in
/// both of its triangles: the arrays of a field take three quarters of the room. Marked edges keep their order.
TriangleMesh OrderTriangles(const TriangleMesh& mesh);
}
