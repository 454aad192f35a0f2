#include "CutGraph.h"

#include "Index.h"
#include "UnionFind.h"

#include <algorithm>
#include <limits>
#include <numeric>
#include <queue>

namespace crossfield
{
namespace
{
/// Shortest edge paths from the boundary, or a vertex of a closed surface, to vertices inside.
struct ShortestPaths
{
  std::vector<double> length;
  std::vector<int> edge; ///< Last edge of the path; −1 where it starts.
};

/// Finds the paths to all goals by Dijkstra's algorithm. Without a boundary they start at a root.
ShortestPaths FindPathsInwards(
  const MeshTopology& topology, const std::vector<bool>& isGoal, int root)
{
  const std::size_t count = Index(topology.VertexCount());
  const EdgeNumbering& edges = topology.edges;
  // Edges at every vertex.
  std::vector<int> start(count + 1, 0);
  for (const auto& [a, b] : edges.vertices)
  {
    ++start[Index(a) + 1];
    ++start[Index(b) + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  std::vector<int> incident(static_cast<std::size_t>(start.back()));
  std::vector<int> filled(start.begin(), start.end() - 1);
  for (int e = 0; e < edges.Count(); ++e)
  {
    for (const int v : edges.vertices[e])
    {
      incident[filled[v]++] = e;
    }
  }

  ShortestPaths paths{ std::vector<double>(count, std::numeric_limits<double>::infinity()),
    std::vector<int>(count, -1) };
  using Item = std::pair<double, int>;
  std::priority_queue<Item, std::vector<Item>, std::greater<>> queue;
  const auto begin = [&](int v)
  {
    paths.length[v] = 0.0;
    queue.emplace(0.0, v);
  };
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    begin(edge.vertices[0]);
  }
  if (topology.mesh.boundary.empty())
  {
    begin(root);
  }
  auto remaining = std::count(isGoal.begin(), isGoal.end(), true);
  while (!queue.empty() && remaining > 0)
  {
    const auto [length, v] = queue.top();
    queue.pop();
    if (length > paths.length[v])
    {
      continue;
    }
    remaining -= isGoal[v] ? 1 : 0;
    for (int i = start[v]; i < start[Index(v) + 1]; ++i)
    {
      const int e = incident[i];
      const auto& [a, b] = edges.vertices[e];
      const int other = a == v ? b : a;
      const double reached = length + topology.Length(e);
      if (reached < paths.length[other])
      {
        paths.length[other] = reached;
        paths.edge[other] = e;
        queue.emplace(reached, other);
      }
    }
  }
  return paths;
}

/// Cuts the path to a vertex, up to the first edge that is cut already.
void CutPath(
  const MeshTopology& topology, const ShortestPaths& paths, int vertex, std::vector<bool>& isCut)
{
  for (int e = paths.edge[vertex]; e >= 0 && !isCut[e]; e = paths.edge[vertex])
  {
    isCut[e] = true;
    const auto& [a, b] = topology.edges.vertices[e];
    vertex = a == vertex ? b : a;
  }
}

/// Cuts the shortest paths that join all loops, and two around each handle: those through an edge that
/// neither they nor a spanning tree of the triangles cross, which crosses edges far from the boundary
/// first.
void CutCycles(const MeshTopology& topology, const ShortestPaths& paths, std::vector<bool>& isCut)
{
  std::vector<bool> isOnPath(isCut.size(), false);
  for (const int e : paths.edge)
  {
    if (e >= 0)
    {
      isOnPath[e] = true;
    }
  }
  std::vector<std::pair<double, int>> bridges;
  for (int e = 0; e < topology.edges.Count(); ++e)
  {
    const auto& [a, b] = topology.edges.vertices[e];
    if (!isOnPath[e] && topology.edges.triangles[e][1] >= 0)
    {
      bridges.emplace_back(paths.length[a] + paths.length[b] + topology.Length(e), e);
    }
  }
  std::sort(bridges.begin(), bridges.end(), std::greater<>());
  UnionFind sides(topology.mesh.triangles.size());
  for (const auto& [length, e] : bridges)
  {
    const auto& [left, right] = topology.edges.triangles[e];
    if (!sides.Join(left, right))
    {
      isCut[e] = true;
      for (const int vertex : topology.edges.vertices[e])
      {
        CutPath(topology, paths, vertex, isCut);
      }
    }
  }
}

/// Returns the cut edges at every vertex.
std::vector<std::vector<int>> CutEdgesAt(
  const MeshTopology& topology, const std::vector<bool>& isCut)
{
  std::vector<std::vector<int>> cutAt(Index(topology.VertexCount()));
  for (int e = 0; e < topology.edges.Count(); ++e)
  {
    if (isCut[e])
    {
      cutAt[topology.edges.vertices[e][0]].push_back(e);
      cutAt[topology.edges.vertices[e][1]].push_back(e);
    }
  }
  return cutAt;
}

/// Removes paths of cut edges that end inside at a vertex that is not singular.
void Prune(const MeshTopology& topology, const std::vector<int>& singular, std::vector<bool>& isCut)
{
  std::vector<std::vector<int>> cutAt = CutEdgesAt(topology, isCut);
  std::vector<bool> isKept(cutAt.size(), false);
  for (const int vertex : singular)
  {
    isKept[vertex] = true;
  }
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    isKept[edge.vertices[0]] = true;
  }
  for (int first = 0; first < topology.VertexCount(); ++first)
  {
    for (int vertex = first; !isKept[vertex] && cutAt[vertex].size() == 1;)
    {
      const int e = cutAt[vertex].front();
      isCut[e] = false;
      cutAt[vertex].clear();
      const auto& [a, b] = topology.edges.vertices[e];
      vertex = a == vertex ? b : a;
      cutAt[vertex].erase(std::find(cutAt[vertex].begin(), cutAt[vertex].end(), e));
    }
  }
}

/// Divides the cut edges into chains at singular vertices, at boundary vertices and at vertices
/// that do not have exactly two cut edges.
std::vector<CutGraph::Chain> FindChains(
  const MeshTopology& topology, const std::vector<bool>& isCut, const std::vector<int>& singular)
{
  const std::size_t count = Index(topology.VertexCount());
  const std::vector<std::vector<int>> cutAt = CutEdgesAt(topology, isCut);
  std::vector<bool> isNode(count, false);
  for (std::size_t v = 0; v < count; ++v)
  {
    isNode[v] = !cutAt[v].empty() && cutAt[v].size() != 2;
  }
  for (const BoundaryEdge& edge : topology.mesh.boundary)
  {
    isNode[edge.vertices[0]] = true;
  }
  for (const int v : singular)
  {
    isNode[v] = true;
  }
  std::vector<CutGraph::Chain> chains;
  std::vector<bool> walked(isCut.size(), false);
  for (int node = 0; node < static_cast<int>(count); ++node)
  {
    for (const int first : cutAt[node])
    {
      if (!isNode[node] || walked[first])
      {
        continue;
      }
      CutGraph::Chain chain;
      chain.vertices.push_back(node);
      for (int e = first;;)
      {
        walked[e] = true;
        const auto& [a, b] = topology.edges.vertices[e];
        const int v = a == chain.vertices.back() ? b : a;
        chain.vertices.push_back(v);
        chain.edges.push_back(e);
        if (isNode[v])
        {
          break;
        }
        e = cutAt[v][0] == e ? cutAt[v][1] : cutAt[v][0];
      }
      chains.push_back(std::move(chain));
    }
  }
  return chains;
}

/// Numbers the vertices of the cut mesh: joins the corners of triangles on both sides of the edges
/// that are not cut. Only vertices on the cut have several copies.
void NumberCorners(const MeshTopology& topology, CutGraph& cut)
{
  const auto& triangles = topology.mesh.triangles;
  std::vector<bool> isOnCut(Index(topology.VertexCount()), false);
  for (const CutGraph::Chain& chain : cut.chains)
  {
    for (const int v : chain.vertices)
    {
      isOnCut[v] = true;
    }
  }
  UnionFind same(3 * triangles.size());
  const auto cornerAt = [&triangles](int t, int vertex)
  {
    const auto& v = triangles[t];
    return 3 * t + static_cast<int>(std::find(v.begin(), v.end(), vertex) - v.begin());
  };
  for (int e = 0; e < topology.edges.Count(); ++e)
  {
    const auto& [t, other] = topology.edges.triangles[e];
    if (other >= 0 && !cut.isCut[e])
    {
      for (const int v : topology.edges.vertices[e])
      {
        if (isOnCut[v])
        {
          same.Join(cornerAt(t, v), cornerAt(other, v));
        }
      }
    }
  }
  // The first copy of a vertex keeps its number.
  std::vector<int> number(3 * triangles.size(), -1);
  std::vector<bool> taken(Index(topology.VertexCount()), false);
  cut.original.resize(Index(topology.VertexCount()));
  std::iota(cut.original.begin(), cut.original.end(), 0);
  cut.corners.resize(triangles.size());
  for (int t = 0; t < static_cast<int>(triangles.size()); ++t)
  {
    for (int i = 0; i < 3; ++i)
    {
      const int v = triangles[t][i];
      if (!isOnCut[v])
      {
        cut.corners[t][i] = v;
        continue;
      }
      int& mine = number[same.Find(3 * t + i)];
      if (mine < 0)
      {
        mine = v;
        if (taken[v])
        {
          mine = static_cast<int>(cut.original.size());
          cut.original.push_back(v);
        }
        taken[v] = true;
      }
      cut.corners[t][i] = mine;
    }
  }
}
}

CutGraph CutOpen(const MeshTopology& topology, const std::vector<int>& singular)
{
  CutGraph cut;
  cut.isCut.assign(Index(topology.edges.Count()), false);
  // Cycles need the paths to all vertices.
  const bool hasCycles = !topology.cycles.empty();
  std::vector<bool> isGoal(Index(topology.VertexCount()), hasCycles);
  for (const int vertex : singular)
  {
    isGoal[vertex] = true;
  }
  const ShortestPaths paths =
    FindPathsInwards(topology, isGoal, singular.empty() ? 0 : singular.front());
  for (const int vertex : singular)
  {
    CutPath(topology, paths, vertex, cut.isCut);
  }
  if (hasCycles)
  {
    CutCycles(topology, paths, cut.isCut);
    Prune(topology, singular, cut.isCut);
  }
  cut.chains = FindChains(topology, cut.isCut, singular);
  NumberCorners(topology, cut);
  return cut;
}
}
