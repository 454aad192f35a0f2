#pragma once

#include "CellLattice.h"
#include "MeshFaces.h"

#include <vector>

namespace crossfield
{
/// The nodes of the cells and faces of a mesh in the order of a format, given by their points or by the numbers
/// that a file gives them. Refers to the mesh.
class ElementNodes
{
public:
  /// Nodes are given by their points.
  ElementNodes(const SolverMesh& mesh, NodeOrder order);
  /// Nodes are numbered from `first` in the order of points; points that no cell has in this format are left out.
  ElementNodes(const SolverMesh& mesh, NodeOrder order, int first);

  /// Returns the nodes of a cell, those of prisms as PrismPositions where the format has prisms.
  std::vector<int> OfCell(int cell) const;

  /// Returns the nodes of a face, which has its normal outwards, or the cell on its left. Triangles
  /// have three or six, where the format has prisms.
  std::vector<int> OfFace(const CellFace& face) const;

  /// Returns the points that cells have in this format, in ascending order.
  const std::vector<int>& UsedPoints() const { return this->Used; }
  /// Returns the number of a point, −1 if it has none.
  int NumberOf(int point) const { return this->Numbers[point]; }

private:
  std::vector<int> PositionsIn(int cell) const;
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
