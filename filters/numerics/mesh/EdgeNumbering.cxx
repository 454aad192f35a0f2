#include "EdgeNumbering.h"

#include "Error.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>

namespace crossfield
{
namespace
{
/// Table of edges grouped by their smaller vertex; its size is linear in that of the mesh.
class EdgeTable
{
public:
  explicit EdgeTable(const TriangleMesh& mesh)
    : First(mesh.points.size(), None)
  {
  }

  /// Returns the number of an edge, and adds the edge if it is new.
  int Number(int a, int b, std::vector<std::array<int, 2>>& vertices)
  {
    const int smaller = std::min(a, b);
    const int larger = std::max(a, b);
    int& first = this->First[smaller];
    for (int edge = first; edge != None; edge = this->Next[edge])
    {
      if (vertices[edge][1] == larger)
      {
        return edge;
      }
    }
    this->Next.push_back(first);
    vertices.push_back({ smaller, larger });
    return first = static_cast<int>(vertices.size()) - 1;
  }

private:
  static constexpr int None = -1;
  std::vector<int> First; ///< Last edge added for each smaller vertex.
  std::vector<int> Next;  ///< For each edge, the one added before it for the same vertex.
};

/// Chains directed edges into loops, one for each kind and id.
std::vector<BoundaryLoop> FindLoops(const std::vector<BoundaryEdge>& edges, std::size_t vertexCount)
{
  std::map<std::tuple<int, int>, std::vector<int>> groups;
  for (std::size_t i = 0; i < edges.size(); ++i)
  {
    groups[{ static_cast<int>(edges[i].kind), edges[i].id }].push_back(static_cast<int>(i));
  }
  std::vector<int> outgoing(vertexCount, -1);
  std::vector<BoundaryLoop> loops;
  for (const auto& [key, group] : groups)
  {
    // One group at a time, because imprinted triangles may share a vertex.
    for (const int i : group)
    {
      outgoing[edges[i].vertices[0]] = i;
    }
    const BoundaryEdge& first = edges[group.front()];
    BoundaryLoop loop{ first.kind, first.id, first.quarterIndex, {} };
    int here = group.front();
    do
    {
      const BoundaryEdge& edge = edges[here];
      if (edge.kind != loop.kind || edge.id != loop.id || edge.quarterIndex != loop.quarterIndex ||
        loop.edges.size() == group.size())
      {
        break;
      }
      loop.edges.push_back(here);
      here = outgoing[edge.vertices[1]];
    } while (here != group.front() && here >= 0);
    if (here != group.front() || loop.edges.size() != group.size())
    {
      throw Error("The lines with BoundaryKind " + std::to_string(static_cast<int>(first.kind)) +
        " and BoundaryId " + std::to_string(first.id) +
        " do not form one closed loop; give a mesh made by the drill filter.");
    }
    if (loop.kind != BoundaryKind::Outer)
    {
      std::reverse(loop.edges.begin(), loop.edges.end());
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}
}

int EdgeNumbering::EulerCharacteristic(const TriangleMesh& mesh) const
{
  std::vector<bool> used(mesh.points.size(), false);
  for (const auto& triangle : mesh.triangles)
  {
    for (int vertex : triangle)
    {
      used[vertex] = true;
    }
  }
  return static_cast<int>(std::count(used.begin(), used.end(), true)) - this->Count() +
    static_cast<int>(mesh.triangles.size());
}

EdgeNumbering NumberEdges(const TriangleMesh& mesh)
{
  constexpr int None = -1;
  EdgeNumbering edges;
  EdgeTable table(mesh);
  edges.vertices.reserve(mesh.triangles.size() * 3 / 2 + mesh.boundary.size());
  edges.ofTriangle.reserve(mesh.triangles.size());
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    std::array<int, 3> numbers{};
    for (std::size_t i = 0; i < 3; ++i)
    {
      numbers[i] =
        table.Number(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3], edges.vertices);
      edges.triangles.resize(edges.vertices.size(), { None, None });
      auto& pair = edges.triangles[numbers[i]];
      if (pair[1] != None)
      {
        throw Error("More than two triangles share an edge; give a manifold triangle mesh.");
      }
      pair[pair[0] == None ? 0 : 1] = static_cast<int>(t);
    }
    edges.ofTriangle.push_back(numbers);
  }
  std::vector<bool> marked(edges.vertices.size(), false);
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    const int number = table.Number(edge.vertices[0], edge.vertices[1], edges.vertices);
    if (number >= static_cast<int>(marked.size()))
    {
      throw Error("A boundary line is not an edge of any triangle; drill the mesh again.");
    }
    marked[number] = true;
    edges.ofBoundary.push_back(number);
  }
  for (std::size_t e = 0; e < marked.size(); ++e)
  {
    if (edges.triangles[e][1] == None && !marked[e])
    {
      throw Error("A boundary edge of the mesh has no line cell with its BoundaryKind; give a mesh "
                  "made by the drill filter.");
    }
  }
  for (const BoundaryEdge& edge : mesh.imprinted)
  {
    const auto number =
      static_cast<std::size_t>(table.Number(edge.vertices[0], edge.vertices[1], edges.vertices));
    if (number >= marked.size() || edges.triangles[number][1] == None || marked[number])
    {
      throw Error("A line of an imprinted circle is not an edge between two triangles, or occurs "
                  "twice; drill the mesh again.");
    }
    marked[number] = true;
    edges.ofImprinted.push_back(static_cast<int>(number));
  }
  return edges;
}

std::vector<int> EdgesOf(const BoundaryLoop& loop, const EdgeNumbering& edges)
{
  const std::vector<int>& numbers =
    loop.kind == BoundaryKind::ImprintedCircle ? edges.ofImprinted : edges.ofBoundary;
  std::vector<int> result;
  result.reserve(loop.edges.size());
  for (const int edge : loop.edges)
  {
    result.push_back(numbers[edge]);
  }
  return result;
}

Point CentreOf(const BoundaryLoop& loop, const TriangleMesh& mesh)
{
  const auto& marked = loop.kind == BoundaryKind::ImprintedCircle ? mesh.imprinted : mesh.boundary;
  Point sum = Point::Zero();
  double length = 0.0;
  for (const int edge : loop.edges)
  {
    const auto& ends = marked[edge].vertices;
    const Point& from = mesh.points[ends[0]];
    const Point& to = mesh.points[ends[1]];
    sum += 0.5 * (to - from).norm() * (from + to);
    length += (to - from).norm();
  }
  return sum / length;
}

std::vector<BoundaryLoop> FindBoundaryLoops(const TriangleMesh& mesh)
{
  return FindLoops(mesh.boundary, mesh.points.size());
}

std::vector<BoundaryLoop> FindImprintedLoops(const TriangleMesh& mesh)
{
  return FindLoops(mesh.imprinted, mesh.points.size());
}
}
