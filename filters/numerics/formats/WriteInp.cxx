#include "WriteInp.h"

#include "CellLattice.h"
#include "Error.h"
#include "FormatNames.h"
#include "Index.h"
#include "MeshNumbering.h"
#include "MeshText.h"
#include "SideFaces.h"

#include <algorithm>

namespace crossfield
{
namespace
{
constexpr std::size_t EntriesOfLine = 16; // most entries of a line of data

/// Adds numbers in lines; a line that ends with a comma continues.
void AddList(const std::vector<int>& numbers, MeshText& text)
{
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const bool isLast = i + 1 == numbers.size();
    text.Add(numbers[i]).Add(isLast ? "\n" : ((i + 1) % EntriesOfLine == 0 ? ",\n" : ", "));
  }
}

void AddNodes(const ExportMesh& mesh, const MeshNumbering& numbering, MeshText& text)
{
  text.Add("*NODE, NSET=NALL\n");
  for (std::size_t i = 0; i < numbering.point.size(); ++i)
  {
    const Eigen::Vector3d& place = mesh.points[Index(numbering.point[i])];
    text.Add(static_cast<int>(i) + 1);
    for (const double coordinate : { place.x(), place.y(), place.z() })
    {
      text.Add(", ").AddIn20(coordinate);
    }
    text.Add('\n');
  }
}

void AddElements(const ExportMesh& mesh, const MeshNumbering& numbering,
  const std::vector<int>& positions, const std::vector<std::string>& regions, MeshText& text)
{
  const std::string type = (mesh.dimension == 2 ? "CPS" : "C3D") + std::to_string(positions.size());
  std::vector<int> entries(positions.size() + 1);
  for (std::size_t region = 0; region < regions.size(); ++region)
  {
    text.Add("*ELEMENT, TYPE=").Add(type).Add(", ELSET=").Add(regions[region]).Add('\n');
    for (int cell = 0; cell < mesh.CellCount(); ++cell)
    {
      if (Index(mesh.region[Index(cell)]) != region)
      {
        continue;
      }
      entries[0] = cell + 1;
      for (std::size_t i = 0; i < positions.size(); ++i)
      {
        entries[i + 1] = numbering.number[Index(mesh.Cell(cell)[positions[i]])];
      }
      AddList(entries, text);
    }
  }
}

void AddSide(const ExportMesh& mesh, const MeshNumbering& numbering,
  const std::vector<SideFace>& faces, const std::string& name, MeshText& text)
{
  const CellLattice lattice(mesh.dimension, mesh.order);
  std::vector<int> nodes;
  std::vector<int> elements;
  for (const SideFace& face : faces)
  {
    for (const int position : lattice.Face(face.face))
    {
      nodes.push_back(numbering.number[Index(mesh.Cell(face.cell)[position])]);
    }
    elements.push_back(face.cell + 1);
  }
  for (std::vector<int>* numbers : { &nodes, &elements })
  {
    std::sort(numbers->begin(), numbers->end());
    numbers->erase(std::unique(numbers->begin(), numbers->end()), numbers->end());
  }
  if (!nodes.empty() && nodes.front() < 0)
  {
    nodes.erase(nodes.begin()); // the node inside a face, which the file does not have
  }
  text.Add("*NSET, NSET=").Add(name).Add('\n');
  AddList(nodes, text);
  text.Add("*ELSET, ELSET=").Add(name).Add('\n');
  AddList(elements, text);
  text.Add("*SURFACE, NAME=").Add(name).Add(", TYPE=ELEMENT\n");
  for (const SideFace& face : faces)
  {
    text.Add(face.cell + 1).Add(", S").Add(face.face + 1).Add('\n');
  }
}

/// Adds a comment for each name that has been changed.
void AddChangedNames(
  const std::vector<std::string>& from, const std::vector<std::string>& to, MeshText& text)
{
  for (std::size_t i = 0; i < from.size(); ++i)
  {
    if (from[i] != to[i])
    {
      std::string line = from[i];
      std::replace_if(
        line.begin(), line.end(), [](char c) { return static_cast<unsigned char>(c) < 0x20U; },
        ' ');
      text.Add("** ").Add(to[i]).Add(": ").Add(line).Add('\n');
    }
  }
}
}

std::string WriteInp(const ExportMesh& mesh)
{
  if (mesh.dimension == 2 && !mesh.HasConstantHeight())
  {
    throw Error(
      "The format .inp has plane elements in a plane z = const only; rotate the domain, or write "
      "a .msh or .vtu file.");
  }
  NameRule rule;
  rule.hasCase = false;
  rule.longest = 72; // CalculiX reads 80 characters and adds some of its own
  std::vector<std::string> names =
    mesh.regionNames; // all different, as regions and sides have sets
  names.insert(names.end(), mesh.sideNames.begin(), mesh.sideNames.end());
  const std::vector<std::string> changed = FormatNames(names, rule, { "NALL" });
  const auto regions = static_cast<std::ptrdiff_t>(mesh.regionNames.size());
  const std::vector<int> positions = CellLattice(mesh.dimension, mesh.order).AbaqusOrder();
  const MeshNumbering numbering = NumberNodes(mesh, positions, 1);
  const SideFaces faces = FindSideFaces(mesh);
  MeshText text;
  text.Add("** Mesh; for plane strain, replace CPS by CPE, for axial symmetry by CAX\n");
  AddChangedNames(names, changed, text);
  AddNodes(mesh, numbering, text);
  AddElements(mesh, numbering, positions, { changed.begin(), changed.begin() + regions }, text);
  for (std::size_t side = 0; side < faces.ofSide.size(); ++side)
  {
    if (!faces.ofSide[side].empty())
    {
      AddSide(mesh, numbering, faces.ofSide[side], changed[mesh.regionNames.size() + side], text);
    }
  }
  return text.Take();
}
}
