#include "Cycle.h"

#include "Error.h"
#include "TriangleSearch.h"
#include "UnionFind.h"

#include <algorithm>

namespace crossfield
{
namespace
{
/// Breadth-first search over triangles: paths back from each triangle to where it started.
class PathSearch
{
public:
  /// Starts behind the edges given, in their order.
  PathSearch(const EdgeNumbering& edges, const std::vector<int>& starts)
    : Edges(edges)
    , Entry(edges.ofTriangle.size(), -1)
    , Order(edges.ofTriangle.size(), 0)
  {
    std::vector<int> first;
    const auto enter = [this](int triangle, int edge, int order)
    {
      this->Entry[triangle] = this->Edges.SideOf(triangle, edge);
      this->Order[triangle] = order;
    };
    for (const int edge : starts)
    {
      const int triangle = edges.triangles[edge][0];
      if (this->Entry[triangle] < 0)
      {
        enter(triangle, edge, static_cast<int>(first.size()));
        first.push_back(triangle);
      }
    }
    this->Starts = static_cast<int>(first.size());
    int count = this->Starts;
    SearchTriangles(
      static_cast<int>(this->Entry.size()), first,
      [&edges](int triangle, int side) { return edges.Neighbour(triangle, side); },
      [&](int triangle, int side, int next)
      { enter(next, edges.ofTriangle[triangle][side], count++); });
  }

  int OrderOf(int triangle) const { return this->Order[triangle]; }
  /// Returns the edge through which a triangle was entered.
  int EntryOf(int triangle) const
  {
    return this->Edges.ofTriangle[triangle][this->Entry[triangle]];
  }
  /// Returns the steps from where the search started to a triangle, which the last one leaves
  /// through an edge.
  std::vector<Cycle::Step> PathTo(int triangle, int edge) const
  {
    if (this->Entry[triangle] < 0)
    {
      throw Error("A part of the mesh has no outer boundary loop; give a connected mesh.");
    }
    std::vector<Cycle::Step> steps;
    while (true)
    {
      const int entry = this->Entry[triangle];
      steps.push_back({ triangle, entry, this->Edges.SideOf(triangle, edge) });
      if (this->Order[triangle] < this->Starts)
      {
        break;
      }
      edge = this->EntryOf(triangle);
      triangle = this->Edges.Neighbour(triangle, entry);
    }
    std::reverse(steps.begin(), steps.end());
    return steps;
  }

private:
  const EdgeNumbering& Edges;
  std::vector<int> Entry; ///< Of each triangle, the side through which it was entered.
  std::vector<int> Order; ///< Of each triangle, how many were reached before it.
  int Starts = 0;         ///< The number of triangles where the search started.
};

/// Appends the shortest strip from the outer loop, or else the first one, to each other loop.
void AddStrips(
  const EdgeNumbering& edges, const std::vector<BoundaryLoop>& loops, std::vector<Cycle>& cycles)
{
  const auto isStart = [&loops](const BoundaryLoop& loop)
  { return loop.kind == BoundaryKind::Outer || &loop == &loops.front(); };
  if (std::all_of(loops.begin(), loops.end(), isStart))
  {
    return;
  }
  std::vector<int> starts;
  for (const BoundaryLoop& loop : loops)
  {
    if (isStart(loop))
    {
      const std::vector<int> all = EdgesOf(loop, edges);
      starts.insert(starts.end(), all.begin(), all.end());
    }
  }
  const PathSearch search(edges, starts);
  for (const BoundaryLoop& loop : loops)
  {
    if (isStart(loop))
    {
      continue;
    }
    // The edge of the loop that the search reached first, and the path to it.
    const auto triangleAt = [&edges](int boundaryEdge)
    { return edges.triangles[edges.ofBoundary[boundaryEdge]][0]; };
    Cycle cycle;
    cycle.lastBoundaryEdge = *std::min_element(loop.edges.begin(), loop.edges.end(),
      [&](int a, int b) { return search.OrderOf(triangleAt(a)) < search.OrderOf(triangleAt(b)); });
    cycle.steps =
      search.PathTo(triangleAt(cycle.lastBoundaryEdge), edges.ofBoundary[cycle.lastBoundaryEdge]);
    const Cycle::Step& first = cycle.steps.front();
    const int start = edges.ofTriangle[first.triangle][first.entry];
    cycle.firstBoundaryEdge =
      static_cast<int>(std::find(edges.ofBoundary.begin(), edges.ofBoundary.end(), start) -
        edges.ofBoundary.begin());
    cycles.push_back(std::move(cycle));
  }
}

/// Appends 2g closed strips: one through every edge that is neither crossed by a spanning tree of the
/// triangles nor in a spanning tree of the vertices (a tree-cotree decomposition).
void AddClosed(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const std::vector<BoundaryLoop>& loops, std::vector<Cycle>& cycles)
{
  const PathSearch search(edges, { 0 });
  std::vector<bool> isUsed(Index(edges.Count()), false);
  UnionFind sets(mesh.points.size());
  const auto join = [&](int edge)
  {
    const auto& [from, to] = edges.vertices[edge];
    isUsed[edge] = isUsed[edge] || sets.Join(from, to);
  };
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
  {
    if (search.OrderOf(t) > 0)
    {
      isUsed[search.EntryOf(t)] = true;
    }
  }
  // As if a polygon filled each loop: a path crosses one of its edges, the others are in the tree.
  for (const BoundaryLoop& loop : loops)
  {
    const std::vector<int> all = EdgesOf(loop, edges);
    std::for_each(all.begin() + 1, all.end(), join);
    isUsed[all.front()] = true;
  }
  for (int edge = 0; edge < edges.Count(); ++edge)
  {
    join(edge);
    if (isUsed[edge])
    {
      continue;
    }
    const auto& [last, first] = edges.triangles[edge];
    Cycle cycle;
    cycle.steps = search.PathTo(last, edge);
    std::vector<Cycle::Step> back = search.PathTo(first, edge);
    // Both paths start in triangle 0; what they share is left out but for their last triangle.
    std::size_t shared = 0;
    while (shared + 1 < std::min(cycle.steps.size(), back.size()) &&
      cycle.steps[shared + 1].triangle == back[shared + 1].triangle)
    {
      ++shared;
    }
    cycle.steps[shared].entry = back[shared].exit;
    cycle.steps.erase(
      cycle.steps.begin(), cycle.steps.begin() + static_cast<std::ptrdiff_t>(shared));
    for (std::size_t i = back.size(); i-- > shared + 1;)
    {
      cycle.steps.push_back({ back[i].triangle, back[i].exit, back[i].entry });
    }
    cycles.push_back(std::move(cycle));
  }
}
}

Eigen::Vector3d Cycle::Step::Left() const
{
  Eigen::Vector3d left = Eigen::Vector3d::Zero();
  left[this->entry] = 1.0;
  if (this->exit == (this->entry + 1) % 3)
  {
    // Both sides meet on the right of the path, and the other two corners are on its left.
    left[(this->entry + 2) % 3] = 1.0;
  }
  return left;
}

std::vector<Cycle> FindCycles(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const std::vector<BoundaryLoop>& loops)
{
  std::vector<Cycle> cycles;
  AddStrips(edges, loops, cycles);
  // 2 − 2g − b = χ
  if (edges.EulerCharacteristic(mesh) + static_cast<int>(loops.size()) < 2)
  {
    AddClosed(mesh, edges, loops, cycles);
  }
  return cycles;
}
}
