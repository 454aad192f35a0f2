#pragma once

#include "SolverMesh.h"

#include <string>

namespace crossfield
{
/// Version of Gmsh's format.
enum class MshVersion
{
  V22, ///< 2.2, for programs that do not read 4.1, such as gmshToFoam
  V41  ///< 4.1
};

/// Returns the text of a Gmsh file (ASCII). Every side is a curve, or a surface of hexahedra, with a
/// physical group of its name, and every region a surface or volume with one; tags count from 1, sides
/// first, and are those of the entities as well. Coordinates are exact. In names " becomes ', and names are
/// cut to 127 bytes. Periodic sides are links of the entities ($Periodic).
///
/// `mesh` is oriented (OrientCells). Throws Error as MeshFaces and MatchPair do.
std::string WriteMsh(const SolverMesh& mesh, MshVersion version);
}
