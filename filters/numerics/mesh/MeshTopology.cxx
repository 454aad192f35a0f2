#include "MeshTopology.h"

#include "TriangleArea.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
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
    ending[mesh.boundary[i].vertices[1]] = static_cast<int>(i);
  }
  std::vector<int> previous;
  previous.reserve(mesh.boundary.size());
  for (const BoundaryEdge& edge : mesh.boundary)
  {
    previous.push_back(ending[edge.vertices[0]]);
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
      vertices.back().push_back(mesh.boundary[edge].vertices[0]);
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

MeshTopology::MeshTopology(TriangleMesh triangles, bool isConnected)
  : mesh(std::move(triangles))
  , edges(NumberEdges(this->mesh))
  , loops(FindBoundaryLoops(this->mesh))
  , imprinted(FindImprintedLoops(this->mesh))
  , cycles(isConnected ? FindCycles(this->mesh, this->edges, this->loops) : std::vector<Cycle>())
  , previous(FindPrevious(this->mesh))
  , turning(static_cast<Eigen::Index>(this->mesh.boundary.size()))
  , alignedVertices(FindAlignedVertices(this->mesh, this->loops))
  , corners(this->mesh.points.size(), false)
{
}

Eigen::Index MeshTopology::LoopCount(BoundaryKind kind) const
{
  return std::count_if(this->loops.begin(), this->loops.end(),
    [kind](const BoundaryLoop& loop) { return loop.kind == kind; });
}

std::pair<int, int> MeshTopology::SideOfBoundary(int position) const
{
  const int edge = this->EdgeOfBoundary(position);
  const int triangle = this->edges.triangles[edge][0];
  return { triangle, this->SideOf(triangle, edge) };
}

double MeshTopology::Length(int edge) const
{
  if (!this->charts)
  {
    // Without looking for a triangle: the search for cuts asks for every edge several times.
    const auto& [from, to] = this->edges.vertices[edge];
    return (this->mesh.points[to] - this->mesh.points[from]).norm();
  }
  const int triangle = this->edges.triangles[edge][0];
  const int side = this->SideOf(triangle, edge);
  return (this->At(triangle, (side + 1) % 3) - this->At(triangle, side)).norm();
}

double MeshTopology::DirectionOf(int triangle, int side) const
{
  const Point along = this->At(triangle, (side + 1) % 3) - this->At(triangle, side);
  return std::atan2(along.y(), along.x());
}

double MeshTopology::AreaOf(int triangle) const
{
  return TriangleArea(this->At(triangle, 0), this->At(triangle, 1), this->At(triangle, 2));
}

SpacePoint MeshTopology::NormalOf(int triangle) const
{
  const auto& v = this->mesh.triangles[triangle];
  const SpacePoint origin = this->PositionOf(v[0]);
  return (this->PositionOf(v[1]) - origin).cross(this->PositionOf(v[2]) - origin).normalized();
}

double MeshTopology::Area() const
{
  double area = 0.0;
  for (int t = 0; t < this->TriangleCount(); ++t)
  {
    area += this->AreaOf(t);
  }
  return area;
}
}
