#include "SurfaceSimplification.h"

#include "Index.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Constrained_placement.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include <map>

namespace crossfield
{
namespace
{
using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Constraints = Mesh::Property_map<Mesh::Edge_index, bool>;

/// Stops at a number of edges.
struct FewEdges
{
  std::size_t count;

  template <class Cost, class Profile>
  bool operator()(const Cost&, const Profile&, std::size_t, std::size_t current) const
  {
    return current <= this->count;
  }
};

Mesh MeshOf(const SurfaceMesh& surface)
{
  Mesh mesh;
  for (const SpacePoint& point : surface.points)
  {
    mesh.add_vertex({ point.x(), point.y(), point.z() });
  }
  const auto vertex = [](int v) { return Mesh::Vertex_index(static_cast<unsigned>(v)); };
  for (const std::array<int, 3>& v : surface.triangles)
  {
    mesh.add_face(vertex(v[0]), vertex(v[1]), vertex(v[2]));
  }
  return mesh;
}

/// Marks the edges of the boundary and sharp ones.
void Constrain(const SurfaceMesh& surface, const FeatureEdges& features, const Mesh& mesh,
  Constraints& constraints)
{
  const auto vertex = [](int v) { return Mesh::Vertex_index(static_cast<unsigned>(v)); };
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
  {
    const std::array<int, 3>& v = surface.triangles[t];
    for (std::size_t i = 0; i < 3; ++i)
    {
      const auto edge = mesh.edge(mesh.halfedge(vertex(v[i]), vertex(v[(i + 1) % 3])));
      constraints[edge] = constraints[edge] || features.isFeature[t][i] || mesh.is_border(edge);
    }
  }
}

SimplifiedSurface ReadOut(const Mesh& mesh, const Constraints& constraints)
{
  SimplifiedSurface result;
  std::map<Mesh::Vertex_index, int> numbers;
  for (const Mesh::Vertex_index vertex : mesh.vertices())
  {
    numbers.emplace(vertex, static_cast<int>(result.surface.points.size()));
    const Kernel::Point_3& point = mesh.point(vertex);
    result.surface.points.emplace_back(point.x(), point.y(), point.z());
  }
  for (const Mesh::Face_index face : mesh.faces())
  {
    std::array<int, 3>& triangle = result.surface.triangles.emplace_back();
    std::array<bool, 3>& sides = result.features.isFeature.emplace_back();
    auto half = mesh.halfedge(face);
    for (std::size_t i = 0; i < 3; ++i)
    {
      triangle[i] = numbers.at(mesh.source(half));
      sides[i] = constraints[mesh.edge(half)] && !mesh.is_border(mesh.edge(half));
      half = mesh.next(half);
    }
  }
  for (const Mesh::Edge_index edge : mesh.edges())
  {
    result.features.count += constraints[edge] && !mesh.is_border(edge) ? 1 : 0;
  }
  return result;
}
}

SimplifiedSurface Simplified(const SurfaceMesh& surface, const FeatureEdges& features, int count)
{
  if (surface.triangles.size() <= Index(count))
  {
    SimplifiedSurface same{ surface, features };
    same.surface.regions.clear();
    same.surface.lines.clear();
    return same;
  }
  Mesh mesh = MeshOf(surface);
  Constraints constraints = mesh.add_property_map<Mesh::Edge_index, bool>("e:stays", false).first;
  Constrain(surface, features, mesh, constraints);
  namespace simplification = CGAL::Surface_mesh_simplification;
  const simplification::Constrained_placement<simplification::LindstromTurk_placement<Mesh>,
    Constraints>
    placement(constraints);
  // A surface has half as many edges again as triangles.
  simplification::edge_collapse(mesh, FewEdges{ Index(count) + Index(count) / 2 },
    CGAL::parameters::get_cost(simplification::LindstromTurk_cost<Mesh>())
      .get_placement(placement)
      .edge_is_constrained_map(constraints));
  mesh.collect_garbage();
  return ReadOut(mesh, constraints);
}
}
