#include "SolverMesh.h"

#include "CellLattice.h"
#include "Error.h"
#include "Index.h"
#include "Plane.h"

#include <Eigen/Geometry>

#include <algorithm>

namespace crossfield
{
namespace
{
void RequireValid(const SolverMesh& mesh)
{
  const auto isPoint = [&mesh](int node) { return node >= 0 && Index(node) < mesh.points.size(); };
  const auto isIn = [](const std::vector<std::string>& names)
  { return [&names](int i) { return i >= 0 && Index(i) < names.size(); }; };
  const bool isValid = (mesh.dimension == 2 || mesh.dimension == 3) && mesh.order >= 1 &&
    mesh.order <= (mesh.dimension == 2 ? 3 : 2) &&
    mesh.cells.size() == mesh.region.size() * Index(mesh.NodesOfCell()) &&
    mesh.faces.size() == mesh.side.size() * Index(mesh.CornersOfFace()) &&
    std::all_of(mesh.cells.begin(), mesh.cells.end(), isPoint) &&
    std::all_of(mesh.faces.begin(), mesh.faces.end(), isPoint) &&
    std::all_of(mesh.region.begin(), mesh.region.end(), isIn(mesh.regionNames)) &&
    std::all_of(mesh.side.begin(), mesh.side.end(), isIn(mesh.sideNames)) &&
    std::all_of(mesh.pairs.begin(), mesh.pairs.end(),
      [isSide = isIn(mesh.sideNames)](const SidePair& pair)
      { return isSide(pair.first) && isSide(pair.second) && pair.first != pair.second; });
  if (!isValid)
  {
    throw Error(
      "The mesh is damaged: numbers of nodes, regions and sides do not match; make it again.");
  }
}
}

std::size_t MeshBlock::PlaceOf(const std::array<int, 3>& index) const
{
  return Index(index[0]) +
    Index(this->cells[0] + 1) * (Index(index[1]) + Index(this->cells[1] + 1) * Index(index[2]));
}

int SolverMesh::NodesOfCell() const
{
  const int along = this->order + 1;
  return this->dimension == 2 ? along * along : along * along * along;
}

const int* SolverMesh::Cell(int cell) const
{
  return this->cells.data() + Index(cell) * Index(this->NodesOfCell());
}

int SolverMesh::CollapsedEdge(int cell) const
{
  const CellLattice lattice(3, this->order);
  const int* nodes = this->Cell(cell);
  const auto isRepeated = [&](int corner)
  { return nodes[lattice.Corner(corner % 4)] == nodes[lattice.Corner(4 + corner % 4)]; };
  for (int edge = 0; this->dimension == 3 && edge < 4; ++edge)
  {
    if (isRepeated(edge) && isRepeated(edge + 1))
    {
      return edge;
    }
  }
  return -1;
}

bool SolverMesh::HasConstantHeight() const
{
  return std::all_of(this->points.begin(), this->points.end(),
    [this](const Eigen::Vector3d& point) { return point.z() == this->points.front().z(); });
}

std::string PlaceOf(const SolverMesh& mesh, int point)
{
  return DescribeInSpace(mesh.points[point]);
}

void OrientCells(SolverMesh& mesh)
{
  RequireValid(mesh);
  for (std::size_t i = 0; i < mesh.points.size(); ++i)
  {
    if (!mesh.points[i].allFinite())
    {
      throw Error("Point " + std::to_string(i) +
        " of the mesh is not finite, so the mesh is damaged; make it again.");
    }
  }
  if (mesh.dimension == 2 && !mesh.HasConstantHeight())
  {
    return; // neither side of a quad in space is the front
  }
  const CellLattice lattice(mesh.dimension, mesh.order);
  const int count = mesh.NodesOfCell();
  std::vector<int> turned(Index(count));
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    const int* nodes = mesh.Cell(cell);
    const auto corner = [&](int i) -> const Eigen::Vector3d&
    { return mesh.points[nodes[lattice.Corner(i)]]; };
    double volume = 0.0; // twice the area of the corners, or a multiple of the volume
    if (mesh.dimension == 2)
    {
      volume = (corner(2) - corner(0)).cross(corner(3) - corner(1)).z();
    }
    else
    {
      const Eigen::Vector3d up = corner(4) + corner(5) + corner(6) + corner(7) - corner(0) -
        corner(1) - corner(2) - corner(3);
      volume = (corner(2) - corner(0)).cross(corner(3) - corner(1)).dot(up);
    }
    if (volume < 0.0)
    {
      for (int node = 0; node < count; ++node)
      {
        turned[node] = nodes[lattice.Transposed(node)];
      }
      std::copy(turned.begin(), turned.end(),
        mesh.cells.begin() + static_cast<std::ptrdiff_t>(cell) * count);
    }
  }
}
}
