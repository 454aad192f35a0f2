#pragma once

#include "ExportMesh.h"
#include "WriteMsh.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Formats of meshes that the numerics write.
enum class MeshFormat
{
  None,
  Foam, ///< a case of OpenFOAM: a folder, NAME/, or NAME.foam in it
  Inp, ///< .inp of Abaqus and CalculiX
  Msh, ///< .msh of Gmsh
  Su2  ///< .su2
};

/// A file to write: its name, with folders, and its bytes.
struct FileText
{
  std::string name;
  std::string text;
};

/// Returns the format that the name of a file or folder asks for: that of its ending, in any case; a folder ends
/// with /.
MeshFormat MeshFormatOf(const std::string& name);

/// Throws Error if the format is None or has no cells of an order.
void RequireOrder(MeshFormat format, int order);

/// Orients the cells of a mesh and returns the files that `name` stands for, in the format of its ending.
/// A case of OpenFOAM has the files of WriteFoam.h and an empty file .foam, with which ParaView opens it.
/// Throws Error if the format cannot have the mesh or the mesh is not complete.
std::vector<FileText> WriteMeshFiles(
  ExportMesh mesh, const std::string& name, MshVersion version = MshVersion::V41);
}
