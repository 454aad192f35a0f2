#pragma once

#include <string>

namespace crossfield
{
/// Throws Error if WriteMeshFiles would replace files of a case of OpenFOAM that are not those of `name` (FoamFolder):
/// a mesh or a blockMeshDict that this program has not written, or a mesh that it has written for another .foam file in the
/// folder. The mesh is that of `name` if a part of it or the dictionary is as it was written: programs of OpenFOAM rewrite
/// `boundary` when its types are edited, or the points when they are scaled.
void RequireOwnCase(const std::string& name);

/// Returns the name of the empty file with which ParaView opens a case: `name` itself, or FOLDER/FOLDER.foam.
std::string FoamMarker(const std::string& name);
}
