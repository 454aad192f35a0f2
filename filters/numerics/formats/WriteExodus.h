#pragma once

#include "SolverMesh.h"

#include <string>

namespace crossfield
{
/// Returns the bytes of an Exodus II file in classic netCDF: an element block for each region and a side set
/// for each side, with their names, of at most 32 bytes. Coordinates are exact.
///
/// Elements are QUAD4, QUAD9, HEX8 or HEX27; quads in space are SHELL4 or SHELL9. Prisms are HEX8 in which
/// nodes occur twice. Nodes count from 1 in the order of the points that cells use, elements block by block.
///
/// `mesh` is oriented (OrientCells) and of order 1 or 2. Throws Error if a side is inside, and as MeshFaces does.
std::string WriteExodus(const SolverMesh& mesh);
}
