#include "EdgeDistances.h"

#include "Index.h"

#include <algorithm>

namespace crossfield
{
EdgeDistances::EdgeDistances(const MeshTopology& topology)
  : Topology(topology)
  , Inside(Index(topology.VertexCount()), true)
  , Neighbours(Index(topology.VertexCount()))
{
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    this->Inside[edge.vertices[0]] = false;
  }
  for (int e = 0; e < topology.edges.Count(); ++e)
  {
    const auto& [from, to] = topology.edges.vertices[e];
    const double length = topology.Length(e);
    this->Neighbours[from].emplace_back(to, length);
    this->Neighbours[to].emplace_back(from, length);
  }
}

std::vector<int> EdgeDistances::Around(int vertex, double distance) const
{
  double longest = 0.0; // edge at the vertex
  std::vector<int> around;
  for (const auto& [next, length] : this->Neighbours[vertex])
  {
    longest = std::max(longest, length);
    if (this->Inside[next])
    {
      around.push_back(next);
    }
  }
  if (distance <= longest)
  {
    return around;
  }
  around.clear();
  this->VisitFrom(vertex,
    [&](int other, double away)
    {
      const SpacePoint place = this->Topology.PositionOf(other);
      const bool isFree = std::all_of(around.begin(), around.end(),
        [&](int taken) { return (this->Topology.PositionOf(taken) - place).norm() >= distance; });
      if (away >= distance && isFree)
      {
        around.push_back(other);
      }
      return away < distance + longest;
    });
  return around;
}
}
