#include "MeshTopology.h"

#include "Error.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
std::vector<int> FindPrevious(const TriangleMesh& mesh)
{
  std::vector<int> ending(mesh.points.size(), -1);
  for (std::size_t i = 0; i < mesh.boundary.size(); ++i)
  {
    ending[static_cast<std::size_t>(mesh.boundary[i].vertices[1])] = static_cast<int>(i);
  }
  std::vector<int> previous;
  previous.reserve(mesh.boundary.size());
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    previous.push_back(ending[static_cast<std::size_t>(edge.vertices[0])]);
  }
  return previous;
}

std::vector<std::vector<int>> FindAlignedVertices(
  const TriangleMesh& mesh, const std::vector<BoundaryLoop>& loops)
{
  std::vector<std::vector<int>> vertices;
  for (const BoundaryLoop& loop : loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      continue;
    }
    vertices.emplace_back();
    for (const int edge : loop.edges)
    {
      vertices.back().push_back(mesh.boundary[static_cast<std::size_t>(edge)].vertices[0]);
    }
    if (loop.kind == BoundaryKind::Inner)
    {
      // BoundaryLoop runs counter-clockwise around the island, with the domain on the right.
      std::reverse(vertices.back().begin(), vertices.back().end());
    }
  }
  return vertices;
}
}

MeshTopology::MeshTopology(TriangleMesh triangles)
  : mesh(std::move(triangles))
  , edges(NumberEdges(this->mesh))
  , loops(FindBoundaryLoops(this->mesh))
  , imprinted(FindImprintedLoops(this->mesh))
  , previous(FindPrevious(this->mesh))
  , turning(static_cast<Eigen::Index>(this->mesh.boundary.size()))
  , alignedVertices(FindAlignedVertices(this->mesh, this->loops))
  , corners(this->mesh.points.size(), false)
{
  const auto direction = [this](int position) -> Point
  {
    const auto& [from, to] = this->BoundaryAt(position).vertices;
    return this->PointAt(to) - this->PointAt(from);
  };
  for (int i = 0; i < static_cast<int>(this->turning.size()); ++i)
  {
    this->turning[i] =
      AngleBetween(direction(this->previous[static_cast<std::size_t>(i)]), direction(i));
    const BoundaryEdge& edge = this->BoundaryAt(i);
    this->corners[static_cast<std::size_t>(edge.vertices[0])] =
      edge.IsAligned() && IsCorner(this->turning[i]);
  }
}

std::vector<Loop> MeshTopology::AlignedLoops() const
{
  std::vector<Loop> aligned;
  for (const std::vector<int>& vertices : this->alignedVertices)
  {
    aligned.emplace_back();
    for (const int vertex : vertices)
    {
      aligned.back().push_back(this->PointAt(vertex));
    }
  }
  return aligned;
}

Eigen::Index MeshTopology::LoopCount(BoundaryKind kind) const
{
  return std::count_if(this->loops.begin(), this->loops.end(),
    [kind](const BoundaryLoop& loop) { return loop.kind == kind; });
}

int MeshTopology::FirstOuterEdge() const
{
  const auto outer = std::find_if(this->loops.begin(), this->loops.end(),
    [](const BoundaryLoop& loop) { return loop.kind == BoundaryKind::Outer; });
  if (outer == this->loops.end())
  {
    throw Error("The mesh has no outer boundary loop; give a mesh made by the drill filter.");
  }
  return outer->edges.front();
}

SharedTopology ShareTopology(TriangleMesh mesh)
{
  return std::make_shared<const MeshTopology>(std::move(mesh));
}
}
