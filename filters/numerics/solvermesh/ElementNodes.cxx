#include "ElementNodes.h"

#include "Index.h"

#include <algorithm>

namespace crossfield
{
ElementNodes::ElementNodes(const SolverMesh& mesh, NodeOrder order)
  : Mesh(mesh)
  , Order(order)
  , HasPrisms(mesh.dimension == 3 && order != NodeOrder::EnSight && order != NodeOrder::Exodus)
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
      this->FacePositions.back().push_back(all[Index(position)]);
    }
  }
}

std::vector<int> ElementNodes::OfCell(int cell) const
{
  const int* nodes = this->Mesh.Cell(cell);
  std::vector<int> points;
  for (const int position : this->Positions)
  {
    points.push_back(nodes[position]);
  }
  const int collapsed = this->HasPrisms ? this->Mesh.CollapsedEdge(cell) : -1;
  if (collapsed < 0)
  {
    return points;
  }
  const auto bottom = [&](int i) { return points[Index((collapsed + i) % 4)]; };
  const auto top = [&](int i) { return points[Index(4 + (collapsed + i) % 4)]; };
  if (this->Order == NodeOrder::Vtk)
  {
    return { bottom(0), top(3), bottom(3), bottom(1), top(2), bottom(2) };
  }
  return { bottom(0), bottom(3), top(3), bottom(1), bottom(2), top(2) };
}

std::vector<int> ElementNodes::OfFace(const CellFace& face) const
{
  const int* nodes = this->Mesh.Cell(face.cell);
  std::vector<int> points;
  for (const int position : this->FacePositions[Index(face.face)])
  {
    points.push_back(nodes[position]);
  }
  if (this->HasPrisms)
  {
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() > 1 && points.front() == points.back())
    {
      points.pop_back();
    }
  }
  return points;
}

std::vector<int> ElementNodes::UsedPoints() const
{
  std::vector<bool> isUsed(this->Mesh.points.size(), false);
  for (int cell = 0; cell < this->Mesh.CellCount(); ++cell)
  {
    const int* nodes = this->Mesh.Cell(cell);
    for (const int position : this->Positions)
    {
      isUsed[Index(nodes[position])] = true;
    }
  }
  std::vector<int> points;
  for (std::size_t point = 0; point < isUsed.size(); ++point)
  {
    if (isUsed[point])
    {
      points.push_back(static_cast<int>(point));
    }
  }
  return points;
}
}
