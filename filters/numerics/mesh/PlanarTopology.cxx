#include "PlanarTopology.h"

#include "Error.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
PlanarTopology::PlanarTopology(TriangleMesh triangles)
  : MeshTopology(std::move(triangles))
{
  const auto direction = [this](int position) -> Point
  {
    const auto& [from, to] = this->BoundaryAt(position).vertices;
    return this->PointAt(to) - this->PointAt(from);
  };
  for (int i = 0; i < static_cast<int>(this->turning.size()); ++i)
  {
    this->turning[i] = AngleBetween(direction(this->previous[i]), direction(i));
    const BoundaryEdge& edge = this->BoundaryAt(i);
    this->corners[edge.vertices[0]] = edge.IsAligned() && IsCorner(this->turning[i]);
  }
}

std::vector<Loop> PlanarTopology::AlignedLoops() const
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

int PlanarTopology::FirstOuterEdge() const
{
  const auto outer = std::find_if(this->loops.begin(), this->loops.end(),
    [](const BoundaryLoop& loop) { return loop.kind == BoundaryKind::Outer; });
  if (outer == this->loops.end())
  {
    throw Error("The mesh has no outer boundary loop; give a mesh made by the drill filter.");
  }
  return outer->edges.front();
}

SharedPlanarTopology ShareTopology(TriangleMesh mesh)
{
  return std::make_shared<const PlanarTopology>(std::move(mesh));
}

SharedPlanarTopology RequirePlanar(const SharedTopology& topology)
{
  auto planar = std::dynamic_pointer_cast<const PlanarTopology>(topology);
  if (!planar)
  {
    throw Error("The mesh is not planar; give a planar one.");
  }
  return planar;
}
}
