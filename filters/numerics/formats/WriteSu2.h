#pragma once

#include "SolverMesh.h"

#include <string>

namespace crossfield
{
/// Returns the text of an SU2 mesh: cells, points and one marker for each side. Coordinates are exact.
/// Names have letters, digits, - and _, and begin with a letter. SU2 has no regions.
///
/// `mesh` is oriented (OrientCells) and of order 1. Throws Error if z is not constant in two dimensions, there are several regions, a side is inside, and as MeshFaces does.
std::string WriteSu2(const SolverMesh& mesh);
}
