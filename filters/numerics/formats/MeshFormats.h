#pragma once

#include "ExportMesh.h"
#include "WriteMsh.h"

#include <string>

namespace crossfield
{
/// Formats of meshes that the numerics write.
enum class MeshFormat
{
  None,
  Inp, ///< .inp of Abaqus and CalculiX
  Msh, ///< .msh of Gmsh
  Su2  ///< .su2
};

/// Returns the format of an ending in lower case with its dot.
MeshFormat MeshFormatOfEnding(const std::string& ending);

/// Throws Error if the format is None or has no cells of an order.
void RequireOrder(MeshFormat format, int order);

/// Orients the cells of a mesh and returns the text of a file. Throws Error if the format cannot have the
/// mesh or the mesh is not complete.
std::string WriteMeshText(ExportMesh mesh, MeshFormat format, MshVersion version = MshVersion::V41);
}
