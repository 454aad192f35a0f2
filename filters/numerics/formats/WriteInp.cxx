#include "WriteInp.h"

#include "CellLattice.h"
#include "Error.h"
#include "FormatNames.h"
#include "Index.h"
#include "MeshNumbering.h"
#include "MeshText.h"
#include "SideFaces.h"

#include <algorithm>
#include <array>

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

/// Adds the elements of a region that are prisms, or those that are not.
void AddElements(const ExportMesh& mesh, const MeshNumbering& numbering,
  const std::vector<int>& positions, int region, bool arePrisms, const std::string& heading,
  MeshText& text)
{
  bool isFirst = true;
  std::vector<int> entries;
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    const int collapsed = mesh.CollapsedEdge(cell);
    if (mesh.region[Index(cell)] != region || (collapsed >= 0) != arePrisms)
    {
      continue;
    }
    entries = { cell + 1 };
    const auto add = [&](int point) { entries.push_back(numbering.number[Index(point)]); };
    if (arePrisms)
    {
      for (const int point : mesh.Prism(cell, collapsed))
      {
        add(point);
      }
    }
    else
    {
      for (const int position : positions)
      {
        add(mesh.Cell(cell)[position]);
      }
    }
    text.Add(isFirst ? heading : "");
    isFirst = false;
    AddList(entries, text);
  }
}

void AddRegions(const ExportMesh& mesh, const MeshNumbering& numbering,
  const std::vector<int>& positions, const std::vector<std::string>& names, MeshText& text)
{
  const std::string type = (mesh.dimension == 2 ? "CPS" : "C3D") + std::to_string(positions.size());
  for (std::size_t region = 0; region < names.size(); ++region)
  {
    const auto number = static_cast<int>(region);
    const std::string end = ", ELSET=" + names[region] + "\n";
    AddElements(mesh, numbering, positions, number, false, "*ELEMENT, TYPE=" + type + end, text);
    AddElements(mesh, numbering, positions, number, true, "*ELEMENT, TYPE=C3D6" + end, text);
  }
}

/// Returns the number of a face in an element, from 1.
int FaceNumber(const ExportMesh& mesh, const SideFace& face)
{
  const int collapsed = mesh.CollapsedEdge(face.cell);
  if (collapsed < 0)
  {
    return face.face + 1;
  }
  // Bottom, top, and around from the collapsed edge, whose face is a line.
  constexpr std::array<int, 6> NumbersOfPrism = { 3, 5, 0, 2, 4, 1 };
  return NumbersOfPrism[Index(face.face < 2 ? face.face : 2 + (face.face + 2 - collapsed) % 4)];
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
    text.Add(face.cell + 1).Add(", S").Add(FaceNumber(mesh, face)).Add('\n');
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
  AddRegions(mesh, numbering, positions, { changed.begin(), changed.begin() + regions }, text);
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
