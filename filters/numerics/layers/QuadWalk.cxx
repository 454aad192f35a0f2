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

std::vector<int> QuadWalk::RowThrough(int side) const
{
  int start = side;
  for (int before = this->Backward(side); before >= 0 && before != side;
       before = this->Backward(before))
  {
    start = before;
  }
  std::vector<int> row = { start };
  for (int next = this->Forward(start); next >= 0 && next != start; next = this->Forward(next))
  {
    row.push_back(next);
  }
  return row;
}

double QuadWalk::Height(int side) const
{
  const auto length = [this](int one)
  {
    return (this->Mesh.points[this->EndOf(one)].place - this->Mesh.points[this->StartOf(one)].place)
      .norm();
  };
  return 0.5 * (length(Next(side)) + length(Previous(side)));
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
