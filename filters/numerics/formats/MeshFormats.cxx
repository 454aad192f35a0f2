#include "MeshFormats.h"

#include "Error.h"
#include "WriteFoam.h"
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

std::vector<FileText> WriteFoamFiles(const ExportMesh& mesh, const std::string& name)
{
  const std::string folder = FoamFolder(name);
  std::string marker = name;
  if (name == folder)
  {
    const std::string last =
      std::filesystem::path(name).parent_path().filename().string(); // without the / at the end
    marker += (last.empty() || last[0] == '.' ? "case" : last) + ".foam";
  }
  std::vector<FileText> files = { { marker, "" } };
  for (auto& [file, text] : WriteFoam(mesh))
  {
    files.push_back({ folder + file, std::move(text) });
  }
  return files;
}
}

MeshFormat MeshFormatOf(const std::string& name)
{
  const std::string ending = LowerCase(std::filesystem::path(name).extension().string());
  if (ending == ".foam" || (!name.empty() && name.back() == '/'))
  {
    return MeshFormat::Foam;
  }
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
    throw Error("The ending of the file is unknown; give .msh, .inp, .su2 or .foam, or a folder with / "
                "at its end.");
  }
  if (format == MeshFormat::Foam && order > 1)
  {
    throw Error("OpenFOAM has cells of order 1 only; leave the order out, or write a .msh or .vtu file.");
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
  case MeshFormat::Foam:
    return WriteFoamFiles(mesh, name);
  case MeshFormat::Inp:
    return { { name, WriteInp(mesh) } };
  case MeshFormat::Su2:
    return { { name, WriteSu2(mesh) } };
  default:
    return { { name, WriteMsh(mesh, version) } };
  }
}
}
