#pragma once

#include "PlanarDomain.h"
#include "SizeField.h"

namespace crossfield
{
/// Predicts the number of triangles of a mesh with edges of length h(x) = min(maximum, min_i
/// (size_i + gradation |x − p_i|)): 4/√3 ∫ h⁻² over the domain, the area of an equilateral triangle
/// being √3/4 h².
///
/// The contribution of the sources is integrated over the entire bounding box, on squares in which
/// h varies little, and half of it is counted, because a short segment of the boundary causes small
/// triangles on both of its sides, but only one side is in the domain. This part is therefore
/// accurate within a factor of two. The running time depends on the sources, not on the number of
/// triangles.
double PredictTriangles(const PlanarDomain& domain, const std::vector<SizeSource>& sources,
  double maximum, double gradation);

/// Throws Error, before meshing, if a mesh with these edge lengths would need more memory than is
/// available, or more triangles than 32-bit indices of matrix entries permit (280 million). A solve
/// on the mesh needs about five times as much memory and checks this itself.
void RequireMemoryForMesh(const PlanarDomain& domain, const std::vector<SizeSource>& sources,
  double maximum, double gradation);

/// Peak memory of meshing in bytes per triangle, including VTK's arrays of the mesh and writing
/// them, if CGAL generates all triangles: 160 and 170 bytes were measured at 4 and 1 million
/// triangles. If most triangles are those of the lattice, as on a disk, it was 100.
constexpr double MeshBytesPerTriangle = 170.0;
}
