#pragma once

#include "SolverMesh.h"

#include <string>

namespace crossfield
{
/// Returns the text of an input file of Abaqus and CalculiX with the mesh alone: *NODE (set NALL),
/// *ELEMENT with a set for each region, and for each side *NSET, *ELSET and *SURFACE of one name. Elements are
/// CPS4 or CPS8 (plane stress), C3D8 or C3D20, so the nodes inside quads and hexahedra of order 2 are left out.
/// Numbers have at most 20 characters, which is what CalculiX reads.
///
/// Names have letters, digits, - and _, begin with a letter, differ in more than case and have at most 72
/// characters; a comment at the top lists names that were changed.
///
/// `mesh` is oriented (OrientCells) and of order 1 or 2. Throws Error if z is not constant in two dimensions,
/// and as MeshFaces does.
std::string WriteInp(const SolverMesh& mesh);
}
