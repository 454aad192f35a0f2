#include "QuadMesh.h"

#include "Error.h"

#include <algorithm>

namespace crossfield
{
int QuadMesh::EulerCharacteristic() const
{
  // Every edge as (smaller, larger, direction), sorted: two of one edge run against each other.
  std::vector<std::array<int, 3>> sides;
  sides.reserve(4 * this->quads.size());
  for (const std::array<int, 4>& quad : this->quads)
  {
    for (std::size_t i = 0; i < 4; ++i)
    {
      const int from = quad[i];
      const int to = quad[(i + 1) % 4];
      if (from == to || from == quad[(i + 2) % 4])
      {
        throw Error("A quad near " + Describe(this->points[static_cast<std::size_t>(from)].place) +
          " has a point twice; use a smaller size.");
      }
      sides.push_back({ std::min(from, to), std::max(from, to), from < to ? 0 : 1 });
    }
  }
  std::sort(sides.begin(), sides.end());
  int edges = 0;
  for (std::size_t i = 0; i < sides.size(); ++i)
  {
    if (i > 0 && sides[i] == sides[i - 1])
    {
      throw Error("An edge near " +
        Describe(this->points[static_cast<std::size_t>(sides[i][0])].place) +
        " has more than two quads; use a smaller size.");
    }
    if (i == 0 || sides[i][0] != sides[i - 1][0] || sides[i][1] != sides[i - 1][1])
    {
      ++edges;
    }
  }
  return static_cast<int>(this->points.size()) - edges + static_cast<int>(this->quads.size());
}
}
