#pragma once

#include "PlanarDomain.h"
#include "Singularity.h"
#include "TriangleMesh.h"

namespace crossfield
{
/// Marks for every singularity the edges of the triangle that contains it, or is nearest to it, as
/// imprinted (docs/method.md §3.7, variant 5; paper, "imposed on only one triangle").
///
/// Throws Error when a quarter index is not 1 or −1, which is all that three values can carry; when
/// a point lies outside the domain; when a triangle has an edge on the boundary, whose value is
/// prescribed already; or when two triangles share an edge.
void MarkTriangles(
  const PlanarDomain& domain, const Configuration& configuration, TriangleMesh& mesh);
}
