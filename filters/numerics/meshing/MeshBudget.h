#pragma once

#include "PlanarDomain.h"
#include "SizeField.h"

namespace crossfield
{
/// Triangles of a mesh with edges of length h(x) = min(maximum, min_i (size_i + gradation |x − p_i|)):
/// 4/√3 ∫ h⁻² over the domain, the area of an equilateral one being √3/4 h².
///
/// The integral of what the sources add is taken over the whole bounding box on squares in which h
/// varies little, and half of it is counted: a short segment of the boundary asks for small
/// triangles on both of its sides. So that part is right within a factor of two. The time is that of
/// the sources, whatever the number of triangles.
double PredictTriangles(const PlanarDomain& domain, const std::vector<SizeSource>& sources,
  double maximum, double gradation);

/// Throws Error, before there is a mesh, when one with these edge lengths would need more memory than
/// there is, or more triangles than 32-bit numbers of matrix entries allow (280 million). A solve
/// on the mesh takes about five times as much and asks for that itself.
void RequireMemoryForMesh(const PlanarDomain& domain, const std::vector<SizeSource>& sources,
  double maximum, double gradation);

/// Peak of meshing per triangle, with the mesh as VTK's arrays and being written, where CGAL makes all of them: 160 and 170 bytes
/// were measured at 4 and 1 million triangles. Where most are the lattice's, as on a disk, it was 100.
constexpr double MeshBytesPerTriangle = 170.0;
}
