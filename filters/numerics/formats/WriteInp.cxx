#include "WriteInp.h"

#include "ElementNodes.h"
#include "FormatNames.h"
#include "MeshText.h"
#include "TiedNodes.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <array>
#include <cmath>

namespace crossfield
{
namespace
{
constexpr std::size_t EntriesOfLine = 16; // most entries of a line of data
constexpr double Zero = 1e-12;            // entries of rotations below are rounding errors

/// Adds numbers in lines; a line that ends with a comma continues.
void AddList(const std::vector<int>& numbers, MeshText& text)
{
  for (std::size_t i = 0; i < numbers.size(); ++i)
  {
    const bool isLast = i + 1 == numbers.size();
    text.Add(numbers[i]).Add(isLast ? "\n" : ((i + 1) % EntriesOfLine == 0 ? ",\n" : ", "));
  }
}

void AddNodes(const SolverMesh& mesh, const ElementNodes& numbering, MeshText& text)
{
  text.Add("*NODE, NSET=NALL\n");
  for (std::size_t i = 0; i < numbering.UsedPoints().size(); ++i)
  {
    const Eigen::Vector3d& place = mesh.points[numbering.UsedPoints()[i]];
    text.Add(static_cast<int>(i) + 1);
    for (const double coordinate : { place.x(), place.y(), place.z() })
    {
      text.Add(", ").AddIn20(coordinate);
    }
    text.Add('\n');
  }
}

/// Returns whether quads are shells: not in a plane z = const.
bool HasShells(const SolverMesh& mesh)
{
  return mesh.dimension == 2 && !mesh.HasConstantHeight();
}

/// Adds the elements of the regions, first those that are not prisms.
void AddRegions(const SolverMesh& mesh, const ElementNodes& numbering,
  const std::vector<std::string>& names, MeshText& text)
{
  std::vector<int> entries;
  for (int group = 0; group < 2 * static_cast<int>(names.size()); ++group)
  {
    bool isFirst = true;
    for (int cell = 0; cell < mesh.CellCount(); ++cell)
    {
      if (mesh.region[cell] != group / 2 || (mesh.CollapsedEdge(cell) >= 0) != (group % 2 == 1))
      {
        continue;
      }
      const std::vector<int> nodes = numbering.OfCell(cell);
      if (isFirst)
      {
        text.Add("*ELEMENT, TYPE=")
          .Add(mesh.dimension == 3 ? "C3D"
              : HasShells(mesh)    ? "S"
                                   : "CPS");
        text.Add(static_cast<int>(nodes.size())).Add(", ELSET=").Add(names[group / 2]).Add('\n');
      }
      isFirst = false;
      entries = { cell + 1 };
      entries.insert(entries.end(), nodes.begin(), nodes.end());
      AddList(entries, text);
    }
  }
}

/// Returns the number of a face in an element, from 1.
int FaceNumber(const SolverMesh& mesh, const CellFace& face)
{
  const int collapsed = mesh.CollapsedEdge(face.cell);
  if (collapsed < 0)
  {
    return face.face + (HasShells(mesh) ? 3 : 1); // 1 and 2 are the two faces of a shell
  }
  // Bottom, top, and around from the collapsed edge, whose face is a line.
  constexpr std::array<int, 6> NumbersOfPrism = { 3, 5, 0, 2, 4, 1 };
  return NumbersOfPrism[face.face < 2 ? face.face : 2 + (face.face + 2 - collapsed) % 4];
}

void AddSide(const SolverMesh& mesh, const ElementNodes& numbering,
  const std::vector<CellFace>& faces, const std::string& name, MeshText& text)
{
  std::vector<int> nodes;
  std::vector<int> elements;
  for (const CellFace& face : faces)
  {
    const std::vector<int> ofFace = numbering.OfFace(face);
    nodes.insert(nodes.end(), ofFace.begin(), ofFace.end());
    elements.push_back(face.cell + 1);
  }
  for (std::vector<int>* numbers : { &nodes, &elements })
  {
    std::sort(numbers->begin(), numbers->end());
    numbers->erase(std::unique(numbers->begin(), numbers->end()), numbers->end());
  }
  text.Add("*NSET, NSET=").Add(name).Add('\n');
  AddList(nodes, text);
  text.Add("*ELSET, ELSET=").Add(name).Add('\n');
  AddList(elements, text);
  text.Add("*SURFACE, NAME=").Add(name).Add(", TYPE=ELEMENT\n");
  for (const CellFace& face : faces)
  {
    text.Add(face.cell + 1).Add(", S").Add(FaceNumber(mesh, face)).Add('\n');
  }
}

/// Adds the equation u_i = Σ R_ij v_j of the displacements of a node and of the node that it is
/// tied to, for degrees of freedom from `first` on.
void AddEquations(
  const TiedNode& tie, const ElementNodes& numbering, int first, int count, MeshText& text)
{
  for (int i = 0; i < count; ++i)
  {
    std::vector<int> columns;
    for (int j = 0; j < count; ++j)
    {
      if (std::abs(tie.rotation(i, j)) > Zero)
      {
        columns.push_back(j);
      }
    }
    text.Add(static_cast<int>(columns.size()) + 1).Add('\n');
    text.Add(numbering.NumberOf(tie.node)).Add(", ").Add(first + i).Add(", 1.");
    for (const int j : columns)
    {
      text.Add(", ").Add(numbering.NumberOf(tie.other)).Add(", ").Add(first + j).Add(", ");
      text.AddIn20(-tie.rotation(i, j));
    }
    text.Add('\n');
  }
}

/// Adds equations that keep a node on the axis of a rotation, along the unit vector a: u_i − (a_i /
/// a_k) u_k = 0, with the largest |a_k|.
void AddAxisEquations(
  const TiedNode& tie, const ElementNodes& numbering, int first, int count, MeshText& text)
{
  Eigen::Vector3d axis = Eigen::AngleAxisd(tie.rotation).axis();
  Eigen::Index largest = 0;
  axis.cwiseAbs().maxCoeff(&largest);
  for (int i = 0; i < count; ++i)
  {
    if (i == largest)
    {
      continue;
    }
    const double slope = axis[i] / axis[largest];
    const bool isSlanted = largest < count && std::abs(slope) > Zero;
    text.Add(isSlanted ? "2\n" : "1\n");
    text.Add(numbering.NumberOf(tie.node)).Add(", ").Add(first + i).Add(", 1.");
    if (isSlanted)
    {
      text.Add(", ")
        .Add(numbering.NumberOf(tie.node))
        .Add(", ")
        .Add(first + static_cast<int>(largest));
      text.Add(", ").AddIn20(-slope);
    }
    text.Add('\n');
  }
}

/// Adds the equations of periodic sides.
void AddPeriodic(
  const SolverMesh& mesh, const MeshFaces& faces, const ElementNodes& numbering, MeshText& text)
{
  const std::vector<TiedNode> ties = TieNodes(mesh, faces);
  if (ties.empty())
  {
    return;
  }
  text.Add(
    "** Displacements of periodic sides match, turned as the side is; for temperatures use degree of freedom 11\n"
    "*EQUATION\n");
  const bool isPlane = mesh.dimension == 2 && !HasShells(mesh);
  for (const TiedNode& tie : ties)
  {
    for (const int first : { 1, 4 }) // displacements, and rotations of shells
    {
      if (first == 1 || HasShells(mesh))
      {
        (tie.node == tie.other ? AddAxisEquations : AddEquations)(
          tie, numbering, first, isPlane ? 2 : 3, text);
      }
    }
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

std::string WriteInp(const SolverMesh& mesh)
{
  NameRule rule;
  rule.hasCase = false;
  rule.longest = 72; // CalculiX reads 80 characters and adds some of its own
  std::vector<std::string> names =
    mesh.regionNames; // all different, as regions and sides have sets
  names.insert(names.end(), mesh.sideNames.begin(), mesh.sideNames.end());
  const std::vector<std::string> changed = FormatNames(names, rule, { "NALL" });
  const auto regions = static_cast<std::ptrdiff_t>(mesh.regionNames.size());
  const ElementNodes numbering(mesh, NodeOrder::Abaqus, 1);
  const MeshFaces faces(mesh);
  MeshText text;
  text.Add(HasShells(mesh)
      ? "** Mesh of shells; give *SHELL SECTION\n"
      : "** Mesh; for plane strain, replace CPS by CPE, for axial symmetry by CAX\n");
  AddChangedNames(names, changed, text);
  AddNodes(mesh, numbering, text);
  AddRegions(mesh, numbering, { changed.begin(), changed.begin() + regions }, text);
  for (int side = 0; side < static_cast<int>(mesh.sideNames.size()); ++side)
  {
    if (!faces.OfSide(side).empty())
    {
      AddSide(
        mesh, numbering, faces.OfSide(side), changed[mesh.regionNames.size() + Index(side)], text);
    }
  }
  AddPeriodic(mesh, faces, numbering, text);
  return text.Take();
}
}
