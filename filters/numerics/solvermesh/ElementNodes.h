#pragma once

#include "CellLattice.h"
#include "MeshFaces.h"

#include <array>
#include <vector>

namespace crossfield
{
/// Corners of a prism in the order of VTK at the corners of the hexahedron that it is in a SolverMesh.
constexpr std::array<int, 8> PrismCorners = { 0, 3, 5, 2, 0, 3, 4, 1 };

/// The nodes of the cells and faces of a mesh in the order of a format, given by their points or by the numbers
/// that a file gives them. Refers to the mesh.
class ElementNodes
{
public:
  /// Nodes are given by their points.
  ElementNodes(const SolverMesh& mesh, NodeOrder order);
  /// Nodes are numbered from `first` in the order of points; points that no cell has in this format are left out.
  ElementNodes(const SolverMesh& mesh, NodeOrder order, int first);

  /// Returns the nodes of a cell. Prisms have six, where the format has them: a triangle, whose normal points
  /// into the prism, in VTK out of it, then the corners opposite to it.
  std::vector<int> OfCell(int cell) const;

  /// Returns the nodes of a face, which has its normal outwards, or the cell on its left. Triangles have three,
  /// where the format has prisms.
  std::vector<int> OfFace(const CellFace& face) const;

  /// Returns the points that cells have in this format, in ascending order.
  const std::vector<int>& UsedPoints() const { return this->Used; }
  /// Returns the number of a point, −1 if it has none.
  int NumberOf(int point) const { return this->Numbers[point]; }

private:
  std::vector<int> NodesAt(int cell, const std::vector<int>& positions) const;

  const SolverMesh& Mesh;
  NodeOrder Order;
  bool HasPrisms;
  std::vector<int> Positions;                  ///< Of the nodes of a cell in its lattice.
  std::vector<std::vector<int>> FacePositions; ///< Of those of its faces.
  std::vector<int> Used;
  std::vector<int> Numbers; ///< Per point.
};
}
