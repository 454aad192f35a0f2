#include "WriteSu2.h"

#include "CellLattice.h"
#include "Error.h"
#include "FormatNames.h"
#include "Index.h"
#include "MeshNumbering.h"
#include "MeshText.h"
#include "SideFaces.h"

#include <array>

namespace crossfield
{
namespace
{
// VTK's types of cells, which SU2 uses.
constexpr int Line = 3;
constexpr int Triangle = 5;
constexpr int Quad = 9;
constexpr int Hexahedron = 12;
constexpr int Wedge = 13;

void RequirePossible(const ExportMesh& mesh, const SideFaces& faces)
{
  if (mesh.dimension == 2 && !mesh.HasConstantHeight())
  {
    throw Error(
      "The format .su2 has meshes in a plane z = const only; rotate the domain, or write a .msh or "
      ".vtu file.");
  }
  if (mesh.regionNames.size() > 1)
  {
    throw Error("The format .su2 has no regions, and this mesh has " +
      std::to_string(mesh.regionNames.size()) +
      "; write each to a file of its own, or a .msh file.");
  }
  for (std::size_t side = 0; side < faces.isInside.size(); ++side)
  {
    if (faces.isInside[side])
    {
      throw Error("The format .su2 has sides on the boundary only, and '" + mesh.sideNames[side] +
        "' is inside; leave it out, or write a .msh or .vtu file.");
    }
  }
}
}

std::string WriteSu2(const ExportMesh& mesh)
{
  const SideFaces faces = FindSideFaces(mesh);
  RequirePossible(mesh, faces);
  const CellLattice lattice(mesh.dimension, 1);
  const std::vector<int> positions = lattice.AbaqusOrder(); // for order 1 that of VTK
  const MeshNumbering numbering = NumberNodes(mesh, positions, 0);
  MeshText text;
  text.Add("NDIME= ").Add(mesh.dimension).Add("\nNELEM= ").Add(mesh.CellCount()).Add('\n');
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    const int collapsed = mesh.CollapsedEdge(cell);
    if (collapsed >= 0)
    {
      const std::array<int, 6> prism = mesh.Prism(cell, collapsed);
      text.Add(Wedge);
      for (const std::size_t i :
        { 0U, 2U, 1U, 3U, 5U, 4U }) // the normals of VTK's triangle point outwards
      {
        text.Add(' ').Add(numbering.number[Index(prism[i])]);
      }
    }
    else
    {
      text.Add(mesh.dimension == 2 ? Quad : Hexahedron);
      for (const int position : positions)
      {
        text.Add(' ').Add(numbering.number[Index(mesh.Cell(cell)[position])]);
      }
    }
    text.Add(' ').Add(cell).Add('\n');
  }
  text.Add("NPOIN= ").Add(static_cast<int>(numbering.point.size())).Add('\n');
  for (std::size_t i = 0; i < numbering.point.size(); ++i)
  {
    const Eigen::Vector3d& place = mesh.points[Index(numbering.point[i])];
    text.Add(place.x()).Add(' ').Add(place.y()).Add(' ');
    if (mesh.dimension == 3)
    {
      text.Add(place.z()).Add(' ');
    }
    text.Add(static_cast<int>(i)).Add('\n');
  }
  const std::vector<std::string> names = FormatNames(mesh.sideNames, {});
  text.Add("NMARK= ").Add(static_cast<int>(names.size())).Add('\n');
  for (std::size_t side = 0; side < names.size(); ++side)
  {
    text.Add("MARKER_TAG= ").Add(names[side]).Add("\nMARKER_ELEMS= ");
    text.Add(static_cast<int>(faces.ofSide[side].size())).Add('\n');
    for (const SideFace& face : faces.ofSide[side])
    {
      std::vector<int> nodes;
      for (const int position : lattice.FaceCorners(face.face))
      {
        nodes.push_back(numbering.number[Index(mesh.Cell(face.cell)[position])]);
      }
      RemoveRepeated(nodes);
      text.Add(mesh.dimension == 2 ? Line : nodes.size() == 3 ? Triangle : Quad);
      for (const int node : nodes)
      {
        text.Add(' ').Add(node);
      }
      text.Add('\n');
    }
  }
  return text.Take();
}
}
