#pragma once

#include "MirrorSector.h"
#include "TriangleMesh.h"

namespace crossfield
{
/// Returns the mesh of the whole domain: the images of the mesh of a sector under all elements of
/// its group, joined at the mirror lines. `marks` has the kind, id and quarter index of each loop
/// of the domain. Its boundary and `vertices` are exactly where they were given.
TriangleMesh CompleteSector(const MirrorSector& sector, const TriangleMesh& mesh,
  const PlanarDomain& domain, const std::vector<Point>& vertices,
  const std::vector<BoundaryEdge>& marks, double reach);
}
