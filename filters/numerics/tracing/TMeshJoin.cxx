#include "TMeshJoin.h"

#include <algorithm>

namespace crossfield
{
namespace
{
void Shift(int& index, std::size_t by)
{
  index += index >= 0 ? static_cast<int>(by) : 0;
}
}

void AppendTMesh(const TMesh& from, const TMeshOffsets& offsets, TMesh& to)
{
  const std::size_t nodes = to.nodes.size();
  const std::size_t halfEdges = to.halfEdges.size();
  const std::size_t patches = to.patches.size();
  for (TNode node : from.nodes)
  {
    Shift(node.cone, offsets.cones);
    to.nodes.push_back(node);
  }
  for (THalfEdge edge : from.halfEdges)
  {
    Shift(edge.node, nodes);
    Shift(edge.next, halfEdges);
    Shift(edge.patch, patches);
    to.halfEdges.push_back(edge);
  }
  for (TArc arc : from.arcs)
  {
    Shift(arc.separatrix, static_cast<std::size_t>(to.separatrixCount));
    Shift(arc.loop, offsets.loops);
    for (ChartPiece& piece : arc.pieces)
    {
      Shift(piece.triangle, offsets.triangles);
      Shift(piece.position, offsets.positions);
    }
    to.arcs.push_back(std::move(arc));
  }
  for (TPatch patch : from.patches)
  {
    for (std::vector<int>& side : patch.sides)
    {
      std::for_each(side.begin(), side.end(), [&](int& edge) { Shift(edge, halfEdges); });
    }
    to.patches.push_back(std::move(patch));
  }
  to.separatrixCount += from.separatrixCount;
  to.extraSeparatrices += from.extraSeparatrices;
  to.headOn += from.headOn;
  to.crossings += from.crossings;
  to.ties += from.ties;
  to.longest = std::max(to.longest, from.longest);
}
}
