#include "CrossField.h"

#include "Error.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
UnwrappedPhase UnwrapPhase(const CrossField& field)
{
  const EdgeNumbering& edges = field.topology->edges;
  const auto hasDirection = [](const Complex& value)
  { return std::isfinite(std::abs(value)) && std::abs(value) > 0.0; };
  if (!std::all_of(field.u.begin(), field.u.end(), hasDirection))
  {
    throw Error("The field is zero or not finite on an edge, where it has no direction; use the "
                "unit-norm method.");
  }
  const auto shortest = [&field](int from, int to)
  { return std::arg(std::conj(field.u[from]) * field.u[to]); };

  UnwrappedPhase phase;
  phase.atEdges.resize(field.u.size());
  std::vector<bool> known(static_cast<std::size_t>(field.u.size()), false);
  std::vector<int> queue = { field.topology->EdgeOfBoundary(field.topology->FirstOuterEdge()) };
  queue.reserve(known.size());
  known[queue.front()] = true;
  phase.atEdges[queue.front()] = std::arg(field.u[queue.front()]);
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    const int from = queue[next];
    for (const int triangle : edges.triangles[from])
    {
      if (triangle < 0)
      {
        continue;
      }
      for (const int to : edges.ofTriangle[triangle])
      {
        if (!known[to])
        {
          known[to] = true;
          phase.atEdges[to] = phase.atEdges[from] + shortest(from, to);
          queue.push_back(to);
        }
      }
    }
  }
  phase.matching.reserve(edges.ofTriangle.size());
  for (const std::array<int, 3>& sides : edges.ofTriangle)
  {
    std::array<int, 3> turns{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      const int from = sides[i];
      const int to = sides[(i + 1) % 3];
      turns[i] = static_cast<int>(
        std::lround((phase.atEdges[to] - phase.atEdges[from] - shortest(from, to)) / (2.0 * Pi)));
    }
    phase.matching.push_back(turns);
  }
  return phase;
}
}
