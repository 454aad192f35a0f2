#pragma once

#include "CellLattice.h"
#include "MeshFaces.h"

#include <array>
#include <vector>

namespace crossfield
{
/// Corners of a prism in the order of VTK at the corners of the hexahedron that it is in a SolverMesh.
constexpr std::array<int, 8> PrismCorners = { 0, 3, 5, 2, 0, 3, 4, 1 };

/// The points of the cells and faces of a mesh in the order of a format. Refers to the mesh.
class ElementNodes
{
public:
  ElementNodes(const SolverMesh& mesh, NodeOrder order);

  /// Returns the points of a cell. Prisms have six, where the format has them: a triangle, whose normal points
  /// into the prism, in VTK out of it, then the corners opposite to it.
  std::vector<int> OfCell(int cell) const;

  /// Returns the points of a face, which has its normal outwards, or the cell on its left. Triangles have three,
  /// where the format has prisms.
  std::vector<int> OfFace(const CellFace& face) const;

  /// Returns the points that cells have in this format, in ascending order.
  std::vector<int> UsedPoints() const;

private:
  const SolverMesh& Mesh;
  NodeOrder Order;
  bool HasPrisms;
  std::vector<int> Positions;                  ///< Of the nodes of a cell in its lattice.
  std::vector<std::vector<int>> FacePositions; ///< Of those of its faces.
};

}
