#include "MeshNumbering.h"

namespace crossfield
{
MeshNumbering::MeshNumbering(const SolverMesh& mesh, NodeOrder order, int first)
  : Nodes(mesh, order)
  , PointOf(this->Nodes.UsedPoints())
  , Numbers(mesh.points.size(), -1)
{
  for (const int point : this->PointOf)
  {
    this->Numbers[Index(point)] = first++;
  }
}

std::vector<int> MeshNumbering::Numbered(std::vector<int> points) const
{
  for (int& point : points)
  {
    point = this->NumberOf(point);
  }
  return points;
}
}
