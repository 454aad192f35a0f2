#include "JoinLayouts.h"

#include "Index.h"
#include "JoinedSurface.h"
#include "TMeshJoin.h"

#include <algorithm>
#include <utility>

namespace crossfield
{
namespace
{
/// Appends the mesh of a region. `loops` is the number of loops before it.
void AppendMesh(const TriangleMesh& from, int loops, TriangleMesh& to)
{
  const auto first = static_cast<int>(to.points.size());
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (std::array<int, 3> triangle : from.triangles)
  {
    for (int& vertex : triangle)
    {
      vertex += first;
    }
    to.triangles.push_back(triangle);
  }
  for (BoundaryEdge edge : from.boundary)
  {
    edge.vertices[0] += first;
    edge.vertices[1] += first;
    edge.id += loops;
    to.boundary.push_back(edge);
  }
}

/// Appends a map but its topology.
void AppendMap(const SeamlessMap& from, int vertices, int rows, SeamlessMap& to)
{
  const auto corners = static_cast<int>(to.points.size());
  const auto transitions = static_cast<int>(to.transitions.size());
  for (std::array<int, 3> triangle : from.corners)
  {
    for (int& corner : triangle)
    {
      corner += corners;
    }
    to.corners.push_back(triangle);
  }
  for (const int vertex : from.original)
  {
    to.original.push_back(vertex + vertices);
  }
  to.points.insert(to.points.end(), from.points.begin(), from.points.end());
  for (std::array<int, 3> sides : from.seams)
  {
    for (int& seam : sides)
    {
      seam += seam > 0 ? transitions : seam < 0 ? -transitions : 0;
    }
    to.seams.push_back(sides);
  }
  to.transitions.insert(to.transitions.end(), from.transitions.begin(), from.transitions.end());
  to.directions.insert(to.directions.end(), from.directions.begin(), from.directions.end());
  for (Cone cone : from.cones)
  {
    cone.vertex += vertices;
    cone.row += cone.row < 0 ? 0 : rows;
    to.cones.push_back(cone);
  }
  to.holonomyDefect.insert(
    to.holonomyDefect.end(), from.holonomyDefect.begin(), from.holonomyDefect.end());
  to.residual = std::max(to.residual, from.residual);
  // The map with the largest strain is reported.
  if (from.flattening &&
    (!to.flattening || from.flattening->predictedStrain > to.flattening->predictedStrain))
  {
    to.flattening = from.flattening;
  }
}

/// Returns the topology of all regions with a common mesh.
SharedTopology Join(TriangleMesh mesh, const std::vector<Layout>& regions)
{
  if (!regions.front().map.topology->charts)
  {
    return ShareTopology(std::move(mesh));
  }
  std::vector<SharedTopology> parts;
  parts.reserve(regions.size());
  for (const Layout& region : regions)
  {
    parts.push_back(region.map.topology);
  }
  return std::make_shared<const JoinedSurface>(std::move(mesh), parts);
}
}

JoinedLayouts JoinLayouts(const std::vector<Layout>& regions)
{
  JoinedLayouts joined;
  Layout& all = joined.layout;
  TriangleMesh mesh;
  std::vector<int> firstVertices;
  int loops = 0;
  for (const Layout& region : regions)
  {
    const MeshTopology& topology = *region.map.topology;
    firstVertices.push_back(static_cast<int>(mesh.points.size()));
    AppendTMesh(region.tMesh,
      { all.map.cones.size(), 0, mesh.triangles.size(), mesh.boundary.size() }, all.tMesh);
    AppendMap(
      region.map, firstVertices.back(), static_cast<int>(all.singularities.size()), all.map);
    AppendMesh(topology.mesh, loops, mesh);
    loops += static_cast<int>(topology.loops.size());
    all.singularities.insert(
      all.singularities.end(), region.singularities.begin(), region.singularities.end());
    all.mapSeconds += region.mapSeconds;
    all.traceSeconds += region.traceSeconds;
    joined.patches.push_back(all.tMesh.patches.size() - region.tMesh.patches.size());
  }
  joined.patches.push_back(all.tMesh.patches.size());
  const SharedTopology topology = Join(std::move(mesh), regions);
  all.map.topology = topology;
  std::vector<int> loopOf(topology->mesh.points.size(), -1);
  for (std::size_t l = 0; l < topology->alignedVertices.size(); ++l)
  {
    for (const int vertex : topology->alignedVertices[l])
    {
      loopOf[Index(vertex)] = static_cast<int>(l);
    }
  }
  for (std::size_t r = 0; r < regions.size(); ++r)
  {
    joined.loops.emplace_back();
    for (const std::vector<int>& vertices : regions[r].map.topology->alignedVertices)
    {
      joined.loops.back().push_back(loopOf[Index(firstVertices[r] + vertices.front())]);
    }
  }
  // The loops of the joined mesh are sorted by kind; without holes all of them are aligned.
  for (TArc& arc : all.tMesh.arcs)
  {
    if (arc.onBoundary)
    {
      const int position = arc.pieces.front().position;
      arc.loop = loopOf[Index(topology->BoundaryAt(position).vertices[0])];
    }
  }
  return joined;
}
}
