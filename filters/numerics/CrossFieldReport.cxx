#include "CrossFieldReport.h"

#include "Error.h"

#include <algorithm>
#include <numeric>
#include <string>

namespace crossfield
{
namespace
{
/// Whether each vertex is one with a chosen quarter index.
std::vector<bool> FindChosen(const TriangleMesh& mesh, const PoincareHopfCount& counted)
{
  std::vector<bool> chosen(mesh.points.size(), false);
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    const auto vertex = static_cast<std::size_t>(edge.vertices[0]);
    chosen[vertex] = std::any_of(counted.corners.begin(), counted.corners.end(),
      [&](const CountedCorner& corner)
      { return corner.chosen && corner.position == mesh.points[vertex]; });
  }
  return chosen;
}

/// Whether each vertex is a corner of an aligned loop.
std::vector<bool> FindCorners(const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops)
{
  std::vector<bool> corner(mesh.points.size(), false);
  for (const BoundaryLoop& loop : loops)
  {
    if (loop.kind != BoundaryKind::Outer && loop.kind != BoundaryKind::Inner)
    {
      continue;
    }
    const auto direction = [&](std::size_t i)
    {
      const auto& ends = mesh.boundary[static_cast<std::size_t>(loop.edges[i])].vertices;
      return Point(mesh.points[static_cast<std::size_t>(ends[1])] -
        mesh.points[static_cast<std::size_t>(ends[0])]);
    };
    const std::size_t count = loop.edges.size();
    for (std::size_t i = 0; i < count; ++i)
    {
      const std::size_t next = (i + 1) % count;
      // The outer loop is walked along its edges, an inner loop against them.
      const auto& edge = mesh.boundary[static_cast<std::size_t>(loop.edges[i])];
      const auto vertex =
        static_cast<std::size_t>(edge.vertices[loop.kind == BoundaryKind::Outer ? 1 : 0]);
      corner[vertex] = IsCorner(AngleBetween(direction(i), direction(next)));
    }
  }
  return corner;
}

/// Holes whose degree is not the prescribed one.
int CountWrongDegrees(const std::vector<BoundaryLoop>& loops, const CrossField& field)
{
  int wrong = 0;
  std::size_t hole = 0;
  for (const BoundaryLoop& loop : loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      wrong += field.holes[hole].degree != loop.quarterIndex ? 1 : 0;
      ++hole;
    }
  }
  return wrong;
}
}

void ReadReport(
  const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops, CrossField& field)
{
  field.holes.clear();
  int degrees = 0;
  for (const BoundaryLoop& loop : loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      field.holes.push_back(ReadHole(loop, field.edges, field.u));
      degrees += field.holes.back().degree;
    }
  }
  FieldIndices indices = ReadIndices(mesh, field.edges, field.u);
  const int sum = std::accumulate(indices.ofTriangle.begin(), indices.ofTriangle.end(), 0) +
    std::accumulate(indices.ofVertex.begin(), indices.ofVertex.end(), 0) + degrees;
  if (sum != 4 * field.count.eulerCharacteristic || !field.u.allFinite())
  {
    throw Error("The indices of the field add up to " + std::to_string(sum) + " instead of " +
      std::to_string(4 * field.count.eulerCharacteristic) +
      ", which cannot be; the field has a zero or non-finite value on an edge.");
  }
  const std::vector<bool> corner = FindCorners(mesh, loops);
  const std::vector<bool> chosen = FindChosen(mesh, field.count);
  MergeAtVertices(mesh, chosen, indices);
  field.wrongDegrees = CountWrongDegrees(loops, field);
  field.unwantedSingularities = 0;
  for (int index : indices.ofTriangle)
  {
    field.unwantedSingularities += index != 0 ? 1 : 0;
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    field.unwantedSingularities += indices.ofVertex[v] != 0 && !corner[v] && !chosen[v] ? 1 : 0;
  }
}
}
