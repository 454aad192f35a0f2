#pragma once

#include "ExportMesh.h"
#include "FaceBuckets.h"

#include <string>
#include <vector>

namespace crossfield
{
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

/// All faces of a mesh: which are the same, and which are in a side. Refers to the mesh; throws Error as
/// FindSideFaces does.
struct MeshFaces
{
  explicit MeshFaces(const ExportMesh& mesh);

  FaceBuckets buckets;
  std::vector<int> partners; ///< FaceBuckets::FindPartners
  SideFaces sides;
};

/// Throws Error, which calls the format `format`, if a side is inside.
void RequireNoInnerSides(const ExportMesh& mesh, const SideFaces& faces, const std::string& format);
}
