#include "LoopStrip.h"

#include <algorithm>

namespace crossfield
{
namespace
{
constexpr int None = -1;

/// Returns the local index of an edge in a triangle.
std::size_t PositionIn(const std::array<int, 3>& edgesOfTriangle, int edge)
{
  return static_cast<std::size_t>(
    std::find(edgesOfTriangle.begin(), edgesOfTriangle.end(), edge) - edgesOfTriangle.begin());
}

/// Returns the step of a strip that crosses a triangle from one of its edges to another.
LoopStrip::Step Pass(const EdgeNumbering& edges, int triangle, int from, int to)
{
  const auto& numbers = edges.ofTriangle[static_cast<std::size_t>(triangle)];
  const std::size_t in = PositionIn(numbers, from);
  const std::size_t out = PositionIn(numbers, to);
  LoopStrip::Step step{ triangle, { 0.0, 0.0, 0.0 } };
  if (out == (in + 2) % 3)
  {
    // Edges i and i + 2 meet in vertex i; the path turns counter-clockwise around it.
    step.left[in] = 1.0;
  }
  else
  {
    // Edges i and i + 1 meet in vertex i + 1; the other two vertices are on the left.
    step.left[in] = 1.0;
    step.left[(in + 2) % 3] = 1.0;
  }
  return step;
}
}

std::vector<LoopStrip> FindLoopStrips(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const std::vector<BoundaryLoop>& loops, bool withHoles)
{
  const auto hasStrip = [withHoles](const BoundaryLoop& loop)
  { return loop.kind == BoundaryKind::Inner || (withHoles && loop.kind == BoundaryKind::Hole); };
  std::vector<LoopStrip> strips;
  if (std::none_of(loops.begin(), loops.end(), hasStrip))
  {
    return strips;
  }
  // Breadth-first over triangles, from all edges of the outer loop at once.
  const auto& triangles = edges.triangles;
  // edge through which each triangle was entered
  std::vector<int> entry(mesh.triangles.size(), None);
  std::vector<int> queue;
  for (const BoundaryLoop& loop : loops)
  {
    for (int boundaryEdge : loop.edges)
    {
      const int edge = edges.ofBoundary[static_cast<std::size_t>(boundaryEdge)];
      const int triangle = triangles[static_cast<std::size_t>(edge)][0];
      if (loop.kind == BoundaryKind::Outer && entry[static_cast<std::size_t>(triangle)] == None)
      {
        entry[static_cast<std::size_t>(triangle)] = edge;
        queue.push_back(triangle);
      }
    }
  }
  for (std::size_t next = 0; next < queue.size(); ++next)
  {
    for (int edge : edges.ofTriangle[static_cast<std::size_t>(queue[next])])
    {
      for (int neighbour : triangles[static_cast<std::size_t>(edge)])
      {
        if (neighbour != None && entry[static_cast<std::size_t>(neighbour)] == None)
        {
          entry[static_cast<std::size_t>(neighbour)] = edge;
          queue.push_back(neighbour);
        }
      }
    }
  }
  std::vector<int> order(mesh.triangles.size(), 0);
  for (std::size_t i = 0; i < queue.size(); ++i)
  {
    order[static_cast<std::size_t>(queue[i])] = static_cast<int>(i);
  }

  for (const BoundaryLoop& loop : loops)
  {
    if (!hasStrip(loop))
    {
      continue;
    }
    // The edge of the loop that the search reached first, and the path back from it.
    const auto reached = [&](int boundaryEdge)
    {
      const int edge = edges.ofBoundary[static_cast<std::size_t>(boundaryEdge)];
      return order[static_cast<std::size_t>(triangles[static_cast<std::size_t>(edge)][0])];
    };
    const int nearest = *std::min_element(
      loop.edges.begin(), loop.edges.end(), [&](int a, int b) { return reached(a) < reached(b); });
    LoopStrip strip;
    strip.lastBoundaryEdge = nearest;
    int out = edges.ofBoundary[static_cast<std::size_t>(nearest)];
    int triangle = triangles[static_cast<std::size_t>(out)][0];
    while (triangle != None)
    {
      const int in = entry[static_cast<std::size_t>(triangle)];
      strip.steps.push_back(Pass(edges, triangle, in, out));
      const auto& pair = triangles[static_cast<std::size_t>(in)];
      triangle = pair[0] == triangle ? pair[1] : pair[0];
      out = in;
    }
    strip.firstBoundaryEdge = static_cast<int>(
      std::find(edges.ofBoundary.begin(), edges.ofBoundary.end(), out) - edges.ofBoundary.begin());
    std::reverse(strip.steps.begin(), strip.steps.end());
    strips.push_back(std::move(strip));
  }
  return strips;
}
}
