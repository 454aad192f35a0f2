#pragma once

// Measures, comparison and modification of triangle meshes for tests.

#include "EdgeNumbering.h"

namespace crossfield::test
{
class Random;

double MeshArea(const TriangleMesh& mesh);
double TriangleArea(const TriangleMesh& mesh, std::size_t triangle);
/// Returns the smallest angle of one triangle, in degrees.
double SmallestAngle(const TriangleMesh& mesh, std::size_t triangle);
double SmallestAngle(const TriangleMesh& mesh);
Point Midpoint(const TriangleMesh& mesh, const EdgeNumbering& edges, int edge);
bool Identical(const TriangleMesh& a, const TriangleMesh& b);

/// Returns the vertices of a boundary loop in the order of its edges.
std::vector<int> WalkedVertices(const TriangleMesh& mesh, const BoundaryLoop& loop);
Loop WalkedPoints(const TriangleMesh& mesh, const BoundaryLoop& loop);

/// Divides each triangle into four; the marks of boundary edges apply to both halves.
TriangleMesh Refine(const TriangleMesh& mesh);

/// Returns the same mesh with its points, triangles and boundary edges in random order, and with
/// each triangle starting at a random corner.
TriangleMesh Renumber(const TriangleMesh& mesh, Random& random);
}
