#pragma once

#include "SolverMesh.h"

#include <string>

namespace crossfield
{
/// Returns the text of an EnSight Gold case whose geometry is a file in the same folder.
std::string WriteEnSightCase(const std::string& geometry);

/// Returns the bytes of a geometry of EnSight Gold ("C Binary", little-endian): a part for each region, then one
/// for each side, by name. The format has coordinates in single precision.
///
/// Elements are quad4, quad8, hexa8 or hexa20, those of sides bar2, bar3, quad4 or quad8. `mesh` is oriented
/// (OrientCells) and of order 1 or 2. Throws Error as MeshFaces does.
std::string WriteEnSightGeometry(const SolverMesh& mesh);
}
