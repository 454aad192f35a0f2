#include "MeshMeasures.h"

#include "Support.h"

#include <algorithm>
#include <numeric>

namespace crossfield::test
{
double TriangleArea(const TriangleMesh& mesh, std::size_t triangle)
{
  const auto& [a, b, c] = mesh.triangles[triangle];
  return 0.5 * Cross(mesh.points[b] - mesh.points[a], mesh.points[c] - mesh.points[a]);
}

double MeshArea(const TriangleMesh& mesh)
{
  double area = 0.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    area += TriangleArea(mesh, t);
  }
  return area;
}

double SmallestAngle(const TriangleMesh& mesh, std::size_t triangle)
{
  double smallest = Pi;
  for (std::size_t i = 0; i < 3; ++i)
  {
    const Point& here = mesh.points[mesh.triangles[triangle][i]];
    const Point& next = mesh.points[mesh.triangles[triangle][(i + 1) % 3]];
    const Point& last = mesh.points[mesh.triangles[triangle][(i + 2) % 3]];
    smallest = std::min(smallest, AngleBetween(next - here, last - here));
  }
  return smallest * 180.0 / Pi;
}

double SmallestAngle(const TriangleMesh& mesh)
{
  double smallest = 180.0;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    smallest = std::min(smallest, SmallestAngle(mesh, t));
  }
  return smallest;
}

Point Midpoint(const TriangleMesh& mesh, const EdgeNumbering& edges, int edge)
{
  const auto& [a, b] = edges.vertices[edge];
  return 0.5 * (mesh.points[a] + mesh.points[b]);
}

bool Identical(const TriangleMesh& a, const TriangleMesh& b)
{
  const auto same = [](const BoundaryEdge& e, const BoundaryEdge& f)
  {
    return e.vertices == f.vertices && e.kind == f.kind && e.id == f.id &&
      e.quarterIndex == f.quarterIndex;
  };
  return a.points == b.points && a.triangles == b.triangles &&
    std::equal(a.boundary.begin(), a.boundary.end(), b.boundary.begin(), b.boundary.end(), same);
}

std::vector<int> WalkedVertices(const TriangleMesh& mesh, const BoundaryLoop& loop)
{
  std::vector<int> vertices;
  for (int edge : loop.edges)
  {
    // Outer loops follow the direction of their edges, the others are reversed.
    vertices.push_back(mesh.boundary[edge].vertices[loop.kind == BoundaryKind::Outer ? 0 : 1]);
  }
  return vertices;
}

Loop WalkedPoints(const TriangleMesh& mesh, const BoundaryLoop& loop)
{
  Loop points;
  for (int vertex : WalkedVertices(mesh, loop))
  {
    points.push_back(mesh.points[vertex]);
  }
  return points;
}

TriangleMesh Refine(const TriangleMesh& mesh)
{
  const EdgeNumbering edges = NumberEdges(mesh);
  const int first = static_cast<int>(mesh.points.size());
  TriangleMesh fine;
  fine.points = mesh.points;
  for (int e = 0; e < edges.Count(); ++e)
  {
    fine.points.push_back(Midpoint(mesh, edges, e));
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& [a, b, c] = mesh.triangles[t];
    const int ab = first + edges.ofTriangle[t][0];
    const int bc = first + edges.ofTriangle[t][1];
    const int ca = first + edges.ofTriangle[t][2];
    fine.triangles.insert(
      fine.triangles.end(), { { a, ab, ca }, { b, bc, ab }, { c, ca, bc }, { ab, bc, ca } });
  }
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    BoundaryEdge half = mesh.boundary[i];
    const int middle = first + edges.ofBoundary[i];
    half.vertices[1] = middle;
    fine.boundary.push_back(half);
    half.vertices = { middle, mesh.boundary[i].vertices[1] };
    fine.boundary.push_back(half);
  }
  return fine;
}

TriangleMesh Renumber(const TriangleMesh& mesh, Random& random)
{
  std::vector<int> place(mesh.points.size());
  std::iota(place.begin(), place.end(), 0);
  random.Shuffle(place);
  TriangleMesh result = mesh;
  for (std::size_t v = 0; v < place.size(); ++v)
  {
    result.points[static_cast<std::size_t>(place[v])] = mesh.points[v];
  }
  for (auto& triangle : result.triangles)
  {
    std::rotate(triangle.begin(), triangle.begin() + random.Integer(0, 2), triangle.end());
    for (int& vertex : triangle)
    {
      vertex = place[static_cast<std::size_t>(vertex)];
    }
  }
  for (BoundaryEdge& edge : result.boundary)
  {
    for (int& vertex : edge.vertices)
    {
      vertex = place[static_cast<std::size_t>(vertex)];
    }
  }
  random.Shuffle(result.triangles);
  random.Shuffle(result.boundary);
  return result;
}
}
