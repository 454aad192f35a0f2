#include "MshElements.h"

#include <map>

namespace crossfield
{
MshElementType MshTypeOf(int type)
{
  static const std::map<int, MshElementType> Types = { { 15, { 0, 1, 1, 1 } },
    // Lines.
    { 1, { 1, 2, 2, 1 } }, { 8, { 1, 3, 2, 2 } }, { 26, { 1, 4, 2, 3 } }, { 27, { 1, 5, 2, 4 } },
    { 28, { 1, 6, 2, 5 } },
    // Triangles, some without inner nodes.
    { 2, { 2, 3, 3, 1 } }, { 9, { 2, 6, 3, 2 } }, { 20, { 2, 9, 3, 3 } }, { 21, { 2, 10, 3, 3 } },
    { 22, { 2, 12, 3, 4 } }, { 23, { 2, 15, 3, 4 } }, { 24, { 2, 15, 3, 5 } },
    { 25, { 2, 21, 3, 5 } },
    // Quadrilaterals.
    { 3, { 2, 4, 4, 1 } }, { 10, { 2, 9, 4, 2 } }, { 16, { 2, 8, 4, 2 } }, { 36, { 2, 16, 4, 3 } },
    { 37, { 2, 25, 4, 4 } },
    // Volumes.
    { 4, { 3, 4, 4, 1 } }, { 5, { 3, 8, 8, 1 } }, { 6, { 3, 6, 6, 1 } }, { 7, { 3, 5, 5, 1 } },
    { 11, { 3, 10, 4, 2 } }, { 12, { 3, 27, 8, 2 } }, { 17, { 3, 20, 8, 2 } } };
  const auto found = Types.find(type);
  return found == Types.end() ? MshElementType() : found->second;
}

std::vector<std::vector<std::size_t>> MshEdges(
  const MshElementType& type, const std::vector<std::size_t>& nodes)
{
  const auto corners = static_cast<std::size_t>(type.corners);
  const auto inner = static_cast<std::size_t>(type.order) - 1;
  std::vector<std::vector<std::size_t>> edges(type.dimension == 1 ? 1 : corners);
  for (std::size_t edge = 0; edge < edges.size(); ++edge)
  {
    edges[edge].push_back(nodes[edge]);
    for (std::size_t i = 0; i < inner; ++i)
    {
      edges[edge].push_back(nodes[corners + edge * inner + i]);
    }
    edges[edge].push_back(nodes[(edge + 1) % corners]);
  }
  return edges;
}
}
