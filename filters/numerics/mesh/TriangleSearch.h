#pragma once

#include "Index.h"

#include <utility>
#include <vector>

namespace crossfield
{
/// Searches triangles breadth-first from given ones. `neighbour(triangle, side)` returns the triangle across
/// a side, or −1 where the search must not pass; `reach(triangle, side, next)` is called once for each
/// other triangle, after the triangle before it.
template <typename Neighbour, typename Reach>
void SearchTriangles(
  int count, std::vector<int> first, const Neighbour& neighbour, const Reach& reach)
{
  std::vector<bool> known(Index(count), false);
  for (const int triangle : first)
  {
    known[triangle] = true;
  }
  std::vector<int> queue = std::move(first);
  for (std::size_t at = 0; at < queue.size(); ++at)
  {
    const int triangle = queue[at];
    for (int side = 0; side < 3; ++side)
    {
      const int next = neighbour(triangle, side);
      if (next >= 0 && !known[next])
      {
        known[next] = true;
        reach(triangle, side, next);
        queue.push_back(next);
      }
    }
  }
}
}
