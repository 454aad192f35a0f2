#include "SideArcs.h"

#include "ArcPosition.h"
#include "Index.h"

#include <algorithm>

namespace crossfield
{
namespace
{
CurvePlace FindMiddle(const SeamlessMap& map, const MeshBoundary& curves, const TArc& arc)
{
  const ChartPiece& piece = *FindOnArc(arc, 0.5 * arc.length).piece;
  return FindOnBoundary(map, curves, piece, 0.5 * (piece.from + piece.to));
}
}

SideArcs::SideArcs(
  const SeamlessMap& map, const MeshBoundary& curves, const BoundarySides& sides, const TMesh& mesh)
  : Mesh(mesh)
{
  const SidesAlong along(sides, curves.GetArcs());
  for (int arc = 0; arc < static_cast<int>(mesh.arcs.size()); ++arc)
  {
    if (mesh.arcs[arc].onBoundary)
    {
      const CurvePlace middle = FindMiddle(map, curves, mesh.arcs[arc]);
      this->Middles[arc] = middle;
      this->SideOf[arc] = along.At(Index(middle.loop), middle.at);
      this->From[mesh.halfEdges[2 * arc].node] = arc;
    }
  }
}

std::vector<int> SideArcs::Of(int side) const
{
  std::vector<int> arcs;
  for (const auto& [arc, its] : this->SideOf)
  {
    if (its == side)
    {
      arcs.push_back(arc);
    }
  }
  return arcs;
}

std::vector<std::vector<int>> SideArcs::PartsOf(int side) const
{
  std::vector<std::vector<int>> parts;
  std::vector<int> remaining = this->Of(side);
  for (const bool distinct : { true, false })
  {
    for (const int first : this->Of(side))
    {
      const int start = this->Mesh.halfEdges[2 * first].node;
      const bool isLeft = std::find(remaining.begin(), remaining.end(), first) != remaining.end();
      if (isLeft && (!distinct || this->Mesh.nodes[start].IsDistinct()))
      {
        parts.push_back(this->Follow(first, remaining));
      }
    }
  }
  return parts;
}

double SideArcs::LengthOf(const std::vector<int>& arcs) const
{
  double length = 0.0;
  for (const int arc : arcs)
  {
    const std::vector<SpacePoint>& line = this->Mesh.arcs[arc].polyline;
    for (std::size_t i = 1; i < line.size(); ++i)
    {
      length += (line[i] - line[i - 1]).norm();
    }
  }
  return length;
}

std::vector<int> SideArcs::Follow(int arc, std::vector<int>& remaining) const
{
  std::vector<int> part;
  auto found = std::find(remaining.begin(), remaining.end(), arc);
  while (found != remaining.end())
  {
    remaining.erase(found);
    part.push_back(arc);
    const int end = this->Mesh.halfEdges[2 * arc + 1].node;
    if (this->Mesh.nodes[end].IsDistinct())
    {
      break;
    }
    arc = this->From.at(end);
    found = std::find(remaining.begin(), remaining.end(), arc);
  }
  return part;
}
}
