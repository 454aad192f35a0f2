#pragma once

#include "CellLattice.h"

#include <vector>

namespace crossfield
{
/// Positions, in the lattice of a hexahedron of order 1 or 2 whose bottom has the edge `collapsed`
/// on an axis (SolverMesh::CollapsedEdge), of the nodes of the prism that it is: corners, then
/// nodes of edges, then those inside its quadrilaterals, in the order of a format. The first
/// triangle has its normal into the prism, in VTK out of it. Nodes inside triangles are none of the
/// prism's.
std::vector<int> PrismPositions(int order, int collapsed, NodeOrder format);

/// Sets the nodes of a lattice that are none of its prism's: those on the axis to the one that they
/// coincide with, those inside the triangles to the middle of the side opposite to the axis.
/// `nodes` is the lattice of a hexahedron with the edge 0 on the axis.
void FillPrismLattice(int order, int* nodes);

/// Removes from the nodes of a face, corners first, those that make a quadrilateral of a triangle
/// whose corners are two times the same point in it.
void KeepTriangle(int order, std::vector<int>& nodes);
}
