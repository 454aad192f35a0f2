#pragma once

#include "ElementNodes.h"

#include <vector>

namespace crossfield
{
/// Numbers of the nodes that a file has, in the order of points; points that no cell of the file uses are left out.
/// Refers to the mesh.
class MeshNumbering
{
public:
  /// Numbers nodes from `first`.
  MeshNumbering(const SolverMesh& mesh, NodeOrder order, int first);

  /// Returns the point of each node.
  const std::vector<int>& Points() const { return this->PointOf; }
  /// Returns the number of a point, −1 if the file does not have it.
  int NumberOf(int point) const { return this->Numbers[Index(point)]; }
  /// Returns the numbers of the nodes of a cell, and of a face; see ElementNodes.
  std::vector<int> OfCell(int cell) const { return this->Numbered(this->Nodes.OfCell(cell)); }
  std::vector<int> OfFace(const CellFace& face) const
  {
    return this->Numbered(this->Nodes.OfFace(face));
  }

private:
  std::vector<int> Numbered(std::vector<int> points) const;

  ElementNodes Nodes;
  std::vector<int> PointOf;
  std::vector<int> Numbers;
};
}
