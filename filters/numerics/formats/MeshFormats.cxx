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

void RequireOrder(MeshFormat format, int order)
{
  if (format == MeshFormat::None)
  {
    throw Error("The ending of the file is unknown; give .msh, .inp or .su2.");
  }
  if (format == MeshFormat::Inp && order > 2)
  {
    throw Error(
      "The format .inp has no elements of order 3; use order 2, or write a .msh or .vtu file.");
  }
  if (format == MeshFormat::Su2 && order > 1)
  {
    throw Error(
      "The format .su2 has cells of order 1 only; leave the order out, or write a .msh or .vtu file.");
  }
}

std::string WriteMeshText(ExportMesh mesh, MeshFormat format, MshVersion version)
{
  RequireOrder(format, mesh.order);
  OrientCells(mesh);
  switch (format)
  {
  case MeshFormat::Inp:
    return WriteInp(mesh);
  case MeshFormat::Su2:
    return WriteSu2(mesh);
  default:
    return WriteMsh(mesh, version);
  }
}
}
