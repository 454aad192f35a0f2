#include "ArcPoints.h"

namespace crossfield
{
ArcPoints::ArcPoints(const TMesh& mesh, const std::vector<int>& counts)
  : Mesh(mesh)
  , Counts(counts)
  , Total(static_cast<int>(mesh.nodes.size()))
{
  for (const int count : counts)
  {
    this->Offsets.push_back(this->Total);
    this->Total += count > 1 ? count - 1 : 0;
  }
}

int ArcPoints::At(int halfEdge, int j) const
{
  const int count = this->Counts[halfEdge / 2];
  if (j == 0)
  {
    return this->Mesh.halfEdges[halfEdge].node;
  }
  if (j == count)
  {
    return this->Mesh.halfEdges[TMesh::Twin(halfEdge)].node;
  }
  return this->Offsets[halfEdge / 2] + (halfEdge % 2 == 0 ? j : count - j) - 1;
}

int ArcPoints::SideCount(const TPatch& patch, std::size_t side) const
{
  int count = 0;
  for (const int half : patch.sides[side])
  {
    count += this->Counts[half / 2];
  }
  return count;
}

std::vector<int> ArcPoints::AlongSide(const TPatch& patch, std::size_t side) const
{
  std::vector<int> points = { this->Mesh.halfEdges[patch.sides[side].front()].node };
  for (const int half : patch.sides[side])
  {
    for (int j = 1; j <= this->Counts[half / 2]; ++j)
    {
      points.push_back(this->At(half, j));
    }
  }
  return points;
}

std::vector<PointLink> ArcPoints::Links() const
{
  std::vector<PointLink> links;
  for (std::size_t a = 0; a < this->Counts.size(); ++a)
  {
    if (this->Counts[a] == 0)
    {
      links.push_back({ this->Mesh.halfEdges[2 * a].node, this->Mesh.halfEdges[2 * a + 1].node,
        static_cast<int>(a), -1, 0 });
    }
  }
  for (std::size_t f = 0; f < this->Mesh.patches.size(); ++f)
  {
    const TPatch& patch = this->Mesh.patches[f];
    for (std::size_t side = 0; side < 2; ++side)
    {
      if (this->SideCount(patch, side) == 0)
      {
        const std::vector<int> one = this->AlongSide(patch, side + 1);
        const std::vector<int> other = this->AlongSide(patch, (side + 3) % 4);
        for (std::size_t j = 0; j < one.size(); ++j)
        {
          links.push_back(
            { one[j], other[one.size() - 1 - j], -1, static_cast<int>(f), static_cast<int>(side) });
        }
      }
    }
  }
  return links;
}
}
