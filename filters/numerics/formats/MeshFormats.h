#pragma once

#include "SolverMesh.h"
#include "WriteMsh.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Formats of meshes that the numerics write.
enum class MeshFormat
{
  None,
  Cgns,   ///< .cgns; WriteMeshFiles does not write it
  Exodus, ///< .ex2, .exo and .e
  Foam,   ///< a case of OpenFOAM: a folder, NAME/, or NAME.foam in it
  Inp,    ///< .inp of Abaqus and CalculiX
  Msh,    ///< .msh of Gmsh
  Plot3d, ///< .xyz of PLOT3D, with a neutral map file
  Su2,    ///< .su2
  Vtk     ///< .vtk; WriteMeshFiles does not write it
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

/// Returns the endings of all formats, separated by blanks, and / for the folder of a case.
std::string MeshEndings();

/// Throws Error if the format is None or has no cells of an order.
void RequireOrder(MeshFormat format, int order);

/// Orients the cells and blocks of a mesh, as its format requires. Throws Error if the mesh is not
/// complete, has no cells, or the format cannot have it.
void PrepareMesh(SolverMesh& mesh, MeshFormat format);

/// Prepares a mesh and returns the files that `name` stands for, in the format of its ending. A case of
/// OpenFOAM has the files of WriteFoam.h and an empty file .foam, with which ParaView opens it.
/// Throws Error if the format cannot have the mesh or the mesh is not complete.
std::vector<FileText> WriteMeshFiles(
  SolverMesh mesh, const std::string& name, MshVersion version = MshVersion::V41);
}
