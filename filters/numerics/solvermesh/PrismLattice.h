#pragma once

#include "CellLattice.h"

#include <vector>

namespace crossfield
{
/// Returns the nodes of a prism as positions in its lattice, in the order of a format: corners,
/// nodes of edges, nodes inside quadrilaterals; a prism has none inside its triangles. The lattice
/// is that of a hexahedron of order 1 or 2 with the edge `collapsed` of its bottom on an axis
/// (SolverMesh::CollapsedEdge). The first triangle has its normal into the prism, in VTK out of it.
std::vector<int> PrismPositions(int order, int collapsed, NodeOrder format);

/// Sets the nodes of a lattice that PrismPositions leaves out, for the edge 0: on the axis those of
/// higher levels are the ones of the lowest, and inside the triangles, where no format has a node,
/// the middle of the side opposite to the axis stands for it.
void FillPrismLattice(int order, int* nodes);

/// If two neighbouring corners of a face are the same point, leaves the nodes of a triangle:
/// corners, then edges. `nodes` are the corners, then the others in the order of VTK, Gmsh or
/// Abaqus.
void KeepTriangle(int order, std::vector<int>& nodes);
}
