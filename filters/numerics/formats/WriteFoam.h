#pragma once

#include "SolverMesh.h"

#include <string>
#include <utility>
#include <vector>

namespace crossfield
{
/// Returns the folder of the case that a name stands for, with / at its end: the name itself if it ends with /,
/// else the folder of the file NAME.foam.
std::string FoamFolder(const std::string& name);

/// Returns the thickness of quads that are written as one layer: the largest power of ten that is at most a tenth
/// of the domain's diagonal.
double FoamThickness(const SolverMesh& quads);

/// Returns the files of an OpenFOAM case, with names relative to its folder, and their texts:
/// points, faces, owner, neighbour and boundary in constant/polyMesh, the zones (cellZones, faceZones, and
/// pointZones without any, so that those of an old mesh go), and system/blockMeshDict if the blocks are
/// known. Coordinates are exact, and points, owner and neighbour have the order of FoamMesh.h.
///
/// `mesh` is oriented (OrientCells) and of order 1. Quads become one layer of FoamThickness. Throws Error if
/// one layer of a translation is not normal to a coordinate axis, as `empty` patches must be, and as SweepQuads and
/// MakeFoamMesh do.
std::vector<std::pair<std::string, std::string>> WriteFoam(const SolverMesh& mesh);
}
