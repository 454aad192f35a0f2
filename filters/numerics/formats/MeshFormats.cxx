#include "MeshFormats.h"

#include "Error.h"
#include "FoamCase.h"
#include "MeshBlocks.h"
#include "MeshFaces.h"
#include "WriteExodus.h"
#include "WriteFoam.h"
#include "WriteInp.h"
#include "WritePlot3d.h"
#include "WriteSu2.h"

#include <filesystem>
#include <map>

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

std::string EndingOf(const std::string& name)
{
  return LowerCase(std::filesystem::path(name).extension().string());
}

const std::map<std::string, MeshFormat> Endings = { { ".cgns", MeshFormat::Cgns },
  { ".e", MeshFormat::Exodus }, { ".ex2", MeshFormat::Exodus }, { ".exo", MeshFormat::Exodus },
  { ".foam", MeshFormat::Foam }, { ".inp", MeshFormat::Inp }, { ".msh", MeshFormat::Msh },
  { ".msh2", MeshFormat::Msh }, { ".su2", MeshFormat::Su2 }, { ".vtk", MeshFormat::Vtk },
  { ".xyz", MeshFormat::Plot3d } };

/// Largest order of each format, and its name in messages.
struct Limit
{
  int order = 1;
  std::string name;
};
const std::map<MeshFormat, Limit> Limits = { { MeshFormat::Cgns, { 1, ".cgns" } },
  { MeshFormat::Exodus, { 2, ".ex2" } }, { MeshFormat::Foam, { 1, ".foam" } },
  { MeshFormat::Inp, { 2, ".inp" } }, { MeshFormat::Msh, { 3, ".msh" } },
  { MeshFormat::Plot3d, { 1, ".xyz" } }, { MeshFormat::Su2, { 1, ".su2" } },
  { MeshFormat::Vtk, { 3, ".vtk" } } };

std::vector<FileText> WriteFoamFiles(const SolverMesh& mesh, const std::string& name)
{
  const std::string folder = FoamFolder(name);
  std::vector<FileText> files = { { FoamMarker(name), "" } };
  for (auto& [file, text] : WriteFoam(mesh))
  {
    files.push_back({ folder + file, std::move(text) });
  }
  return files;
}
}

MeshFormat MeshFormatOf(const std::string& name)
{
  if (!name.empty() && name.back() == '/')
  {
    return MeshFormat::Foam;
  }
  const auto format = Endings.find(EndingOf(name));
  return format == Endings.end() ? MeshFormat::None : format->second;
}

std::string MeshEndings()
{
  std::string list;
  for (const auto& [ending, format] : Endings)
  {
    list += ending + " ";
  }
  return list + "/";
}

void RequireOrder(MeshFormat format, int order)
{
  const auto limit = Limits.find(format);
  if (limit == Limits.end())
  {
    std::string list;
    for (const auto& [ending, of] : Endings)
    {
      list += (list.empty() ? "" : ", ") + ending;
    }
    throw Error("The ending of the file is unknown; give one of " + list +
      ", or a folder with / at its end.");
  }
  if (order > limit->second.order)
  {
    const bool hasSecond = limit->second.order > 1;
    throw Error("The format " + limit->second.name +
      (hasSecond ? " has no elements of order 3; use order 2,"
                 : " has cells of order 1 only; leave the order out,") +
      " or write a .msh or .vtu file.");
  }
}

void PrepareMesh(SolverMesh& mesh, MeshFormat format)
{
  RequireOrder(format, mesh.order);
  OrientCells(mesh);
  if (mesh.region.empty())
  {
    throw Error("The mesh has no cells; give the quads of a Quad Mesher.");
  }
  if (format == MeshFormat::Plot3d || format == MeshFormat::Cgns)
  {
    if (mesh.regionNames.size() > 1)
    {
      RemoveInnerSides(mesh); // these formats have sides on the boundary only
    }
    RequireBlocks(mesh, Limits.at(format).name);
    OrientBlocks(mesh);
  }
}

std::vector<FileText> WriteMeshFiles(SolverMesh mesh, const std::string& name, MshVersion version)
{
  const MeshFormat format = MeshFormatOf(name);
  PrepareMesh(mesh, format);
  switch (format)
  {
  case MeshFormat::Exodus:
    return { { name, WriteExodus(mesh) } };
  case MeshFormat::Foam:
    return WriteFoamFiles(mesh, name);
  case MeshFormat::Inp:
    return { { name, WriteInp(mesh) } };
  case MeshFormat::Plot3d:
    return { { name, WritePlot3d(mesh) },
      { std::filesystem::path(name).replace_extension(".nmf").string(), WriteNmf(mesh) } };
  case MeshFormat::Su2:
    return { { name, WriteSu2(mesh) } };
  case MeshFormat::Cgns:
  case MeshFormat::Vtk:
    throw Error("Other libraries write .cgns and .vtk files; use vtkQuadMeshWriter.");
  default:
    return { { name, WriteMsh(mesh, EndingOf(name) == ".msh2" ? MshVersion::V22 : version) } };
  }
}
}
