#pragma once

#include "SeamlessMap.h"
#include "SurfaceMesh.h"
#include "TriangleMesh.h"

namespace crossfield::test
{
/// Returns the unit sphere as a cube with 6 n × n squares, each cut into four triangles around its centre,
/// blown up so that angles along the middle lines of the faces are equal. It has the symmetries of the cube,
/// whose corners are its first eight points.
SurfaceMesh CubedSphere(int n);

/// Returns a cylinder of radius 1 between z = −1 and z = 1 with its ends, with the triangles of that sphere.
SurfaceMesh Can(int n);

/// Returns the part of that sphere with z ≥ 0; n is even.
SurfaceMesh Hemisphere(int n);

/// Returns cones of index 1 at the corners of the cube in either of them.
std::vector<Cone> ConesOfCube(const SurfaceMesh& surface);

/// Returns the torus of circles of radius 1 around a circle of radius R > 1, as m × n quadrilaterals that
/// are cut into two triangles: n along the small circles. With even m and n it has the reflections of the torus.
SurfaceMesh Torus(double R, int m, int n);

/// Returns the surface of a box of 2g + 1 by 3 by 1 cubes without every second one of the middle row: genus g. Each
/// square of a cube is divided into n × n squares of two triangles.
SurfaceMesh BoxWithHoles(int genus, int n);

/// Returns the unit square as n × n squares, each cut into two triangles.
TriangleMesh GridOfSquare(int n);

/// Returns cones at the corners of that square, and a pair inside.
std::vector<Cone> ConesOfSquare(int n);

/// Bends a mesh with its vertices on the lines x = i / n along these lines: each strip between two of them gets a
/// random direction in the plane of x and z, at most `largest` radians from x. Then turns it. Lengths stay.
SurfaceMesh BentAtRandom(const TriangleMesh& mesh, int n, unsigned seed, double largest = 3.0);

/// Returns the turn of BentAtRandom: with `largest` 0 the mesh is the turned one.
Eigen::Matrix3d TurnOfBent();
}
