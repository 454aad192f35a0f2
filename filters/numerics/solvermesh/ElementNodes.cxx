#include "ElementNodes.h"

#include "PrismLattice.h"

#include <algorithm>

namespace crossfield
{
ElementNodes::ElementNodes(const SolverMesh& mesh, NodeOrder order)
  : Mesh(mesh)
  , Order(order)
  , HasPrisms(mesh.dimension == 3 && order != NodeOrder::Exodus)
{
  const CellLattice lattice(mesh.dimension, mesh.order);
  this->Positions = lattice.OrderFor(order);
  const std::vector<int> ofFace = CellLattice(mesh.dimension - 1, mesh.order).OrderFor(order);
  for (int face = 0; face < lattice.FaceCount(); ++face)
  {
    const std::vector<int> all = lattice.Face(face);
    this->FacePositions.emplace_back();
    for (const int position : ofFace)
    {
      this->FacePositions.back().push_back(all[position]);
    }
  }
  std::vector<bool> isUsed(mesh.points.size(), false);
  for (int cell = 0; cell < mesh.CellCount(); ++cell)
  {
    for (const int position : this->PositionsIn(cell))
    {
      isUsed[mesh.Cell(cell)[position]] = true;
    }
  }
  for (int point = 0; point < static_cast<int>(isUsed.size()); ++point)
  {
    this->Numbers.push_back(point);
    if (isUsed[point])
    {
      this->Used.push_back(point);
    }
  }
}

ElementNodes::ElementNodes(const SolverMesh& mesh, NodeOrder order, int first)
  : ElementNodes(mesh, order)
{
  std::fill(this->Numbers.begin(), this->Numbers.end(), -1);
  for (const int point : this->Used)
  {
    this->Numbers[point] = first++;
  }
}

std::vector<int> ElementNodes::NodesAt(int cell, const std::vector<int>& positions) const
{
  const int* nodes = this->Mesh.Cell(cell);
  std::vector<int> numbers;
  numbers.reserve(positions.size());
  for (const int position : positions)
  {
    numbers.push_back(this->NumberOf(nodes[position]));
  }
  return numbers;
}

std::vector<int> ElementNodes::PositionsIn(int cell) const
{
  const int collapsed = this->HasPrisms ? this->Mesh.CollapsedEdge(cell) : -1;
  return collapsed < 0 ? this->Positions : PrismPositions(this->Mesh.order, collapsed, this->Order);
}

std::vector<int> ElementNodes::OfCell(int cell) const
{
  return this->NodesAt(cell, this->PositionsIn(cell));
}

std::vector<int> ElementNodes::OfFace(const CellFace& face) const
{
  std::vector<int> nodes = this->NodesAt(face.cell, this->FacePositions[face.face]);
  if (this->HasPrisms)
  {
    KeepTriangle(this->Mesh.order, nodes);
  }
  return nodes;
}
}
