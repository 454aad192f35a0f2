#pragma once

#include "MeshFaces.h"

#include <string>
#include <vector>

namespace crossfield
{
/// A part of the boundary in OpenFOAM: faces one after the other.
struct FoamPatch
{
  std::string name;
  std::string type;
  std::string neighbour; ///< Of type cyclic: the other patch, whose faces are in the same order.
  int start = 0;         ///< Number of its first face.
  int count = 0;
};

/// Cells or faces with a name.
struct FoamZone
{
  std::string name;
  std::vector<int> members;
};

/// A mesh as OpenFOAM has it: polygons between cells, first the inner ones and then patch by patch.
///
/// Inner faces are in upper-triangular order: the owner is the neighbour with the smaller number, faces go by
/// owner and then by neighbour. The normal of a face, by the right-hand rule, points out of its owner.
struct FoamMesh
{
  std::vector<int> point;   ///< Per point, that of the mesh; those that no cell uses are left out.
  std::vector<int> corners; ///< Points of all faces.
  std::vector<int> starts;  ///< Per face, and at the end, its beginning in `corners`.
  std::vector<int> owner;   ///< Per face, a cell.
  std::vector<int> neighbour; ///< Per inner face, the other cell.
  std::vector<FoamPatch> patches;
  std::vector<FoamZone> cellZones; ///< Regions, if there is more than one.
  std::vector<FoamZone> faceZones; ///< Sides that are inside.
};

/// Returns the patches of a mesh without their faces, in the order of sides: of the type that the mesh
/// has for them, or else `patch`; the ends of one layer are the patch `frontAndBack` of type `empty` if it
/// was a translation, and `wedge` if it was a revolution; periodic sides are `cyclic`. `patchOf` receives
/// the patch of each side. Names are words of OpenFOAM (FormatNames.h).
std::vector<FoamPatch> FoamPatches(const SolverMesh& mesh, std::vector<int>& patchOf);

/// Returns the faces of a mesh of hexahedra and prisms of order 1, which is oriented (OrientCells). Nodes that a
/// face has twice are left out of it, and faces with two nodes are left out. Faces of cyclic patches begin with
/// nodes that match.
///
/// Throws Error if a face is between three cells or twice in one, a side is in part inside, and as
/// MatchPair does.
FoamMesh MakeFoamMesh(const SolverMesh& mesh, const MeshFaces& faces);
}
