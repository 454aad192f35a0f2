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
/// if a face with one cell is missing. The second function uses the buckets of the mesh and their partners.
SideFaces FindSideFaces(const ExportMesh& mesh);
SideFaces FindSideFaces(
  const ExportMesh& mesh, const FaceBuckets& buckets, const std::vector<int>& partners);

/// Throws Error, which calls the format `format`, if a side is inside.
void RequireNoInnerSides(const ExportMesh& mesh, const SideFaces& faces, const std::string& format);
}
