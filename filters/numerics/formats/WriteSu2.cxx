#include "WriteSu2.h"

#include "CellLattice.h"
#include "Error.h"
#include "FormatNames.h"
#include "Index.h"
#include "MeshNumbering.h"
#include "MeshText.h"
#include "SideFaces.h"

namespace crossfield
{
namespace
{
// VTK's types of cells, which SU2 uses.
constexpr int Line = 3;
constexpr int Quad = 9;
constexpr int Hexahedron = 12;

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
  RequireNoInnerSides(mesh, faces, ".su2");
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
    text.Add(mesh.dimension == 2 ? Quad : Hexahedron);
    for (const int position : positions)
    {
      text.Add(' ').Add(numbering.number[Index(mesh.Cell(cell)[position])]);
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
      text.Add(mesh.dimension == 2 ? Line : Quad);
      for (const int position : lattice.FaceCorners(face.face))
      {
        text.Add(' ').Add(numbering.number[Index(mesh.Cell(face.cell)[position])]);
      }
      text.Add('\n');
    }
  }
  return text.Take();
}
}
