#include "MeshFormats.h"

#include "Error.h"
#include "WriteInp.h"
#include "WriteSu2.h"

namespace crossfield
{
MeshFormat MeshFormatOfEnding(const std::string& ending)
{
  if (ending == ".inp")
  {
    return MeshFormat::Inp;
  }
  if (ending == ".msh")
  {
    return MeshFormat::Msh;
  }
  return ending == ".su2" ? MeshFormat::Su2 : MeshFormat::None;
}

std::string WriteMeshText(ExportMesh mesh, MeshFormat format, MshVersion version)
{
  OrientCells(mesh);
  switch (format)
  {
  case MeshFormat::Inp:
    return WriteInp(mesh);
  case MeshFormat::Msh:
    return WriteMsh(mesh, version);
  case MeshFormat::Su2:
    return WriteSu2(mesh);
  default:
    throw Error("The ending of the file is unknown; give .msh, .inp or .su2.");
  }
}
}
