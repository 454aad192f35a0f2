#pragma once

#include "ExportMesh.h"

#include <array>
#include <string>
#include <vector>

namespace crossfield
{
/// Corners of a face in ascending order, each once; the last one is repeated. The last two of an edge are 0.
using FaceKey = std::array<int, 4>;

/// Returns the key of a face with 2 or 4 corners, of which a triangle has one twice.
FaceKey KeyOfFace(FaceKey corners, int count);

/// A boundary face as a part of a cell.
struct SideFace
{
  int cell = 0;
  int face = 0; ///< Number of the face in the cell (CellLattice.h).
};

/// Faces of a mesh by side, in their order.
struct SideFaces
{
  std::vector<std::vector<SideFace>> ofSide;
  std::vector<bool>
    isInside; ///< Per side, whether there are cells on both sides of one of its faces.
};

/// Finds the cell of every boundary face. Throws Error if a face belongs to no cell or is given twice, or
/// if a face with one cell is missing.
SideFaces FindSideFaces(const ExportMesh& mesh);

/// Throws Error, which calls the format `format`, if a side is inside.
void RequireNoInnerSides(const ExportMesh& mesh, const SideFaces& faces, const std::string& format);
}
