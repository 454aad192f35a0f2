#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"
#include "TriangleMesh.h"

namespace crossfield
{
/// Marks for each singularity the edges of the triangle that contains it, or is nearest to it, as
/// imprinted (docs/method.md §3.7, variant 5; paper, "imposed on only one triangle").
///
/// Throws Error if a quarter index is not ±1, the only values that three edges can represent; if a
/// point is outside the domain; if a triangle has an edge on the boundary, whose value is
/// prescribed already; or if two triangles share an edge.
void MarkTriangles(
  const PlanarDomain& domain, const Configuration& configuration, TriangleMesh& mesh);
}
