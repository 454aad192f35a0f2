#pragma once

#include "MeshTopology.h"

#include <functional>
#include <map>
#include <queue>
#include <utility>
#include <vector>

namespace crossfield
{
/// Distances along the edges of a mesh between its inner vertices. The topology must outlive the object.
class EdgeDistances
{
public:
  explicit EdgeDistances(const MeshTopology& topology);

  /// Visits vertices inside by increasing distance from one, which need not be inside, until visit(vertex, distance)
  /// returns false or all are visited.
  template <typename Visit>
  void VisitFrom(int start, const Visit& visit) const
  {
    using Entry = std::pair<double, int>;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> queue;
    std::map<int, double> best = { { start, 0.0 } };
    queue.emplace(0.0, start);
    while (!queue.empty())
    {
      const auto [distance, vertex] = queue.top();
      queue.pop();
      if (distance > best.at(vertex))
      {
        continue;
      }
      if (this->Inside[vertex] && !visit(vertex, distance))
      {
        return;
      }
      for (const auto& [next, length] : this->Neighbours[vertex])
      {
        const auto [found, isNew] = best.emplace(next, distance + length);
        if (isNew || distance + length < found->second)
        {
          found->second = distance + length;
          queue.emplace(distance + length, next);
        }
      }
    }
  }

  /// Returns vertices around one inside, in all directions: the nearest ones inside that are at least a distance away
  /// from it and from each other; where edges are longer, its neighbours.
  std::vector<int> Around(int vertex, double distance) const;

private:
  const MeshTopology& Topology;
  std::vector<bool> Inside;
  std::vector<std::vector<std::pair<int, double>>> Neighbours;
};
}
