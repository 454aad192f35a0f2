#include "QuadWalk.h"

#include <map>

namespace crossfield
{
QuadWalk::QuadWalk(const QuadMesh& mesh)
  : Mesh(mesh)
  , Twins(mesh.Twins())
{
}

int QuadWalk::StartOf(int side) const
{
  return this->Mesh.quads[side / 4][side % 4];
}

int QuadWalk::EndOf(int side) const
{
  return this->StartOf(Next(side));
}

int QuadWalk::Forward(int side) const
{
  const int twin = this->Twin(Next(side));
  return twin < 0 ? -1 : Next(twin);
}

int QuadWalk::Backward(int side) const
{
  const int twin = this->Twin(Previous(side));
  return twin < 0 ? -1 : Previous(twin);
}

std::vector<int> QuadWalk::OfBoundary() const
{
  std::map<std::array<int, 2>, int> open;
  for (int side = 0; side < static_cast<int>(this->Twins.size()); ++side)
  {
    if (this->Twin(side) < 0)
    {
      open[{ this->StartOf(side), this->EndOf(side) }] = side;
    }
  }
  std::vector<int> sides;
  sides.reserve(this->Mesh.boundary.size());
  for (const QuadBoundaryEdge& edge : this->Mesh.boundary)
  {
    sides.push_back(open.at(edge.points));
  }
  return sides;
}
}
