#include "WriteSu2.h"

#include "ElementNodes.h"
#include "Error.h"
#include "FormatNames.h"
#include "MeshText.h"

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

void RequirePossible(const SolverMesh& mesh, const MeshFaces& faces)
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
  for (std::size_t side = 0; side < mesh.sideNames.size(); ++side)
  {
    if (faces.IsInside(static_cast<int>(side)))
    {
      throw Error("The format .su2 has sides on the boundary only, and '" + mesh.sideNames[side] +
        "' is inside; leave it out, or write a .msh or .vtu file.");
    }
  }
}
}

std::string WriteSu2(const SolverMesh& mesh)
{
  const MeshFaces faces(mesh);
  RequirePossible(mesh, faces);
  const ElementNodes numbering(mesh, NodeOrder::Vtk, 0);
  MeshText text;
  const auto addElement = [&text](int type, const std::vector<int>& nodes)
  {
    text.Add(type);
    for (const int node : nodes)
    {
      text.Add(' ').Add(node);
    }
  };
  text.Add("NDIME= ").Add(mesh.dimension).Add("\nNELEM= ").Add(mesh.CellCount()).Add('\n');
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    const std::vector<int> nodes = numbering.OfCell(cell);
    addElement(nodes.size() == 4 ? Quad : nodes.size() == 6 ? Wedge : Hexahedron, nodes);
    text.Add(' ').Add(cell).Add('\n');
  }
  text.Add("NPOIN= ").Add(static_cast<int>(numbering.UsedPoints().size())).Add('\n');
  for (std::size_t i = 0; i < numbering.UsedPoints().size(); ++i)
  {
    const Eigen::Vector3d& place = mesh.points[numbering.UsedPoints()[i]];
    text.Add(place.x()).Add(' ').Add(place.y()).Add(' ');
    if (mesh.dimension == 3)
    {
      text.Add(place.z()).Add(' ');
    }
    text.Add(static_cast<int>(i)).Add('\n');
  }
  const std::vector<std::string> names = FormatNames(mesh.sideNames, {});
  text.Add("NMARK= ").Add(static_cast<int>(names.size())).Add('\n');
  for (int side = 0; side < static_cast<int>(names.size()); ++side)
  {
    text.Add("MARKER_TAG= ").Add(names[side]).Add("\nMARKER_ELEMS= ");
    text.Add(static_cast<int>(faces.OfSide(side).size())).Add('\n');
    for (const CellFace& face : faces.OfSide(side))
    {
      const std::vector<int> nodes = numbering.OfFace(face);
      addElement(nodes.size() == 2 ? Line : nodes.size() == 3 ? Triangle : Quad, nodes);
      text.Add('\n');
    }
  }
  return text.Take();
}
}
