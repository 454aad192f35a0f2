#include "MeshFormats.h"

#include "Error.h"
#include "WriteInp.h"
#include "WriteSu2.h"

#include <filesystem>

namespace crossfield
{
namespace
{
std::string LowerCase(std::string text)
{
  for (char& character : text)
  {
    character =
      character >= 'A' && character <= 'Z' ? static_cast<char>(character - 'A' + 'a') : character;
  }
  return text;
}
}

MeshFormat MeshFormatOf(const std::string& name)
{
  const std::string ending = LowerCase(std::filesystem::path(name).extension().string());
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

std::vector<FileText> WriteMeshFiles(ExportMesh mesh, const std::string& name, MshVersion version)
{
  const MeshFormat format = MeshFormatOf(name);
  RequireOrder(format, mesh.order);
  OrientCells(mesh);
  switch (format)
  {
  case MeshFormat::Inp:
    return { { name, WriteInp(mesh) } };
  case MeshFormat::Su2:
    return { { name, WriteSu2(mesh) } };
  default:
    return { { name, WriteMsh(mesh, version) } };
  }
}
}
