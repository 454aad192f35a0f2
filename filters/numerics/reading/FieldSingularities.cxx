#include "FieldSingularities.h"

#include "BoundaryCorners.h"
#include "Error.h"
#include "UnionFind.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace crossfield
{
namespace
{
using Place = FieldSingularity::Place;

/// Role of a vertex given by the boundary.
struct VertexRole
{
  Place place = Place::Inside;
  int id = -1;
  bool corner = false;
};

std::vector<VertexRole> FindRoles(
  const PlanarTopology& topology, const FieldSingularityOptions& options)
{
  std::vector<VertexRole> roles(topology.mesh.points.size());
  for (std::size_t i = 0; i < topology.mesh.boundary.size(); ++i)
  {
    const BoundaryEdge& edge = topology.mesh.boundary[i];
    if (edge.IsAligned())
    {
      VertexRole& role = roles[edge.vertices[0]];
      role.place = edge.kind == BoundaryKind::Outer ? Place::OuterLoop : Place::InnerLoop;
      role.id = edge.id;
      role.corner = IsCorner(topology.turning[static_cast<Eigen::Index>(i)], options.cornerAngle);
    }
  }
  for (const int vertex : options.chosenVertices)
  {
    roles[vertex].corner = true;
  }
  return roles;
}

/// Singular triangles and vertices that are read as one singularity.
struct Cluster
{
  int quarterIndex = 0;
  int weight = 0; ///< Σ |index|.
  Point weighted = Point::Zero();
  VertexRole role; ///< Role of its vertices as long as all are on a loop.
  bool onBoundary = true;
  double edge = 0.0; ///< Longest edge at its vertices and at those of its triangles.
  /// Zeros of the piecewise linear field with the sign of quarterIndex.
  std::vector<Point> zeros;
  /// Whether the mean may be outside the domain, so that one of `places` is used.
  bool touchesBoundary = false;
  /// Candidate positions: all if all are on the boundary, otherwise those inside.
  std::vector<Point> places;
  std::vector<int> vertices; ///< Vertex of each of `places`; −1 for the centroid of a triangle.

  void Add(int index, const Point& place, int vertex, const VertexRole& at, double longestEdge)
  {
    this->edge = std::max(this->edge, longestEdge);
    this->quarterIndex += index;
    this->weight += std::abs(index);
    this->weighted += std::abs(index) * place;
    const bool boundary = at.place != Place::Inside;
    if (this->onBoundary && !boundary)
    {
      this->places.clear();
      this->vertices.clear();
    }
    this->onBoundary = this->onBoundary && boundary;
    if (this->onBoundary || !boundary)
    {
      this->places.push_back(place);
      this->vertices.push_back(vertex);
    }
    this->touchesBoundary = this->touchesBoundary || boundary;
    this->role = at;
  }
};

/// Returns the zero of the linear function on a triangle with the values u at the midpoints of its
/// sides, if the zero lies in the triangle and the Jacobian determinant has sign `sign`.
std::optional<Point> LinearZero(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const ComplexVector& u, std::size_t t, int sign)
{
  const auto& sides = edges.ofTriangle[t];
  const Complex sum = u[sides[0]] + u[sides[1]] + u[sides[2]];
  Complex corners[3];
  for (std::size_t i = 0; i < 3; ++i)
  {
    corners[i] = sum - 2.0 * u[sides[(i + 1) % 3]];
  }
  double coordinates[3];
  double total = 0.0;
  for (std::size_t i = 0; i < 3; ++i)
  {
    coordinates[i] = std::imag(std::conj(corners[(i + 1) % 3]) * corners[(i + 2) % 3]);
    total += coordinates[i];
  }
  if (!(total * sign > 0.0))
  {
    return std::nullopt;
  }
  Point zero = Point::Zero();
  for (std::size_t i = 0; i < 3; ++i)
  {
    const double barycentric = coordinates[i] / total;
    if (barycentric < 0.0)
    {
      return std::nullopt;
    }
    zero += barycentric * mesh.points[mesh.triangles[t][i]];
  }
  return zero;
}

Point Centroid(const TriangleMesh& mesh, std::size_t t)
{
  Point sum = Point::Zero();
  for (const int vertex : mesh.triangles[t])
  {
    sum += mesh.points[vertex];
  }
  return sum / 3.0;
}

/// Returns the longest edge at each vertex marked in the second argument.
std::vector<double> LongestEdges(const PlanarTopology& topology, const std::vector<char>& marked)
{
  std::vector<double> longest(topology.mesh.points.size(), 0.0);
  for (const auto& [from, to] : topology.edges.vertices)
  {
    if (marked[from] == 0 && marked[to] == 0)
    {
      continue;
    }
    const double length = (topology.PointAt(to) - topology.PointAt(from)).norm();
    for (const int vertex : { from, to })
    {
      double& here = longest[vertex];
      here = std::max(here, length);
    }
  }
  return longest;
}

/// Merges singular triangles and vertices away from corners.
std::map<int, Cluster> FindClusters(
  const CrossField& field, const FieldIndices& indices, const std::vector<VertexRole>& roles)
{
  const TriangleMesh& mesh = field.topology->mesh;
  const EdgeNumbering& edges = field.topology->edges;
  const auto singular = [&](int vertex)
  {
    const auto v = static_cast<std::size_t>(vertex);
    return indices.ofVertex[v] != 0 && !roles[v].corner;
  };
  UnionFind sets(mesh.points.size());
  std::vector<char> marked(mesh.points.size());
  for (std::size_t v = 0; v < marked.size(); ++v)
  {
    marked[v] = singular(static_cast<int>(v)) ? 1 : 0;
  }
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (indices.ofTriangle[t] != 0)
    {
      for (const int vertex : mesh.triangles[t])
      {
        marked[vertex] = 1;
      }
      sets.Join(mesh.triangles[t][0], mesh.triangles[t][1]);
      sets.Join(mesh.triangles[t][1], mesh.triangles[t][2]);
    }
  }
  for (const auto& [from, to] : edges.vertices)
  {
    if (singular(from) && singular(to))
    {
      sets.Join(from, to);
    }
  }

  const std::vector<double> longest = LongestEdges(*field.topology, marked);
  std::map<int, Cluster> clusters;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    if (indices.ofTriangle[t] != 0)
    {
      const auto [a, b, c] = mesh.triangles[t];
      const double edge = std::max({ longest[a], longest[b], longest[c] });
      Cluster& cluster = clusters[sets.Find(a)];
      cluster.Add(indices.ofTriangle[t], Centroid(mesh, t), -1, VertexRole(), edge);
      cluster.touchesBoundary = cluster.touchesBoundary ||
        std::any_of(mesh.triangles[t].begin(), mesh.triangles[t].end(),
          [&roles](int vertex) { return roles[vertex].place != Place::Inside; });
    }
  }
  for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v)
  {
    if (singular(v))
    {
      const auto vertex = static_cast<std::size_t>(v);
      clusters[sets.Find(v)].Add(
        indices.ofVertex[vertex], mesh.points[vertex], v, roles[vertex], longest[vertex]);
    }
  }
  // Search for zeros in the singular triangles and around the singular vertices.
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
  {
    const auto& triangle = mesh.triangles[t];
    const auto* const around = std::find_if(triangle.begin(), triangle.end(), singular);
    if (indices.ofTriangle[t] == 0 && around == triangle.end())
    {
      continue;
    }
    Cluster& cluster = clusters[sets.Find(indices.ofTriangle[t] != 0 ? triangle[0] : *around)];
    if (const auto zero = LinearZero(mesh, edges, field.u, t, cluster.quarterIndex))
    {
      cluster.zeros.push_back(*zero);
    }
  }
  return clusters;
}

/// Returns the index of the nearest of several points.
std::size_t Nearest(const std::vector<Point>& points, const Point& centre)
{
  const auto nearest = std::min_element(points.begin(), points.end(),
    [&centre](const Point& a, const Point& b)
    { return (a - centre).squaredNorm() < (b - centre).squaredNorm(); });
  return static_cast<std::size_t>(nearest - points.begin());
}

FieldSingularity Describe(const Cluster& cluster)
{
  FieldSingularity singularity;
  singularity.quarterIndex = cluster.quarterIndex;
  singularity.position = cluster.weighted / cluster.weight;
  singularity.edge = cluster.edge;
  if (cluster.onBoundary)
  {
    singularity.place = cluster.role.place;
    singularity.id = cluster.role.id;
  }
  if (!cluster.onBoundary && std::abs(cluster.quarterIndex) == 1 && !cluster.zeros.empty())
  {
    singularity.position = cluster.zeros[Nearest(cluster.zeros, singularity.position)];
  }
  else if (cluster.touchesBoundary)
  {
    const std::size_t nearest = Nearest(cluster.places, singularity.position);
    singularity.position = cluster.places[nearest];
    singularity.vertex = cluster.onBoundary ? cluster.vertices[nearest] : -1;
  }
  return singularity;
}

FieldSingularity DescribeHole(
  const TriangleMesh& mesh, const BoundaryLoop& loop, const HoleReading& reading)
{
  FieldSingularity hole;
  hole.place = Place::Hole;
  hole.id = loop.id;
  hole.quarterIndex = reading.degree;
  const auto vertex = [&](int edge) { return mesh.points[mesh.boundary[edge].vertices[0]]; };
  for (const int edge : loop.edges)
  {
    hole.position += vertex(edge) / static_cast<double>(loop.edges.size());
  }
  for (const int edge : loop.edges)
  {
    hole.radius += (vertex(edge) - hole.position).norm() / static_cast<double>(loop.edges.size());
  }
  return hole;
}
}

std::vector<FieldSingularity> FindFieldSingularities(
  const CrossField& field, const FieldSingularityOptions& options)
{
  const int count = field.topology->edges.Count();
  if (field.u.size() != count || !field.u.allFinite())
  {
    throw Error("The field has " + std::to_string(field.u.size()) + " values for " +
      std::to_string(count) + " edges, or some that are not finite numbers; compute it again.");
  }
  return FindFieldSingularities(field, ReadIndices(*field.topology, field.u), options);
}

std::vector<FieldSingularity> FindFieldSingularities(
  const CrossField& field, const FieldIndices& indices, const FieldSingularityOptions& options)
{
  const PlanarTopology& topology = *field.topology;
  const TriangleMesh& mesh = topology.mesh;
  FieldIndices merged = indices;
  const std::vector<VertexRole> roles = FindRoles(topology, options);
  std::vector<bool> corners;
  corners.reserve(roles.size());
  for (const VertexRole& role : roles)
  {
    corners.push_back(role.corner);
  }
  MergeAtVertices(mesh, corners, merged);
  std::vector<FieldSingularity> found;
  int sum = 0;
  int holes = 0;
  for (const auto& [root, cluster] : FindClusters(field, merged, roles))
  {
    sum += cluster.quarterIndex;
    if (cluster.quarterIndex != 0)
    {
      found.push_back(Describe(cluster));
    }
  }
  for (std::size_t v = 0; v < mesh.points.size(); ++v)
  {
    if (roles[v].corner)
    {
      sum += merged.ofVertex[v];
      if (options.corners && merged.ofVertex[v] != 0)
      {
        found.push_back({ { mesh.points[v], merged.ofVertex[v], 0.0 }, roles[v].place, roles[v].id,
          static_cast<int>(v), 0.0 });
      }
    }
  }
  for (const BoundaryLoop& loop : topology.loops)
  {
    if (loop.kind == BoundaryKind::Hole)
    {
      const HoleReading reading = ReadHole(loop, topology.edges, field.u);
      sum += reading.degree;
      ++holes;
      if (options.holes && reading.degree != 0)
      {
        found.push_back(DescribeHole(mesh, loop, reading));
      }
    }
  }
  const int required = 4 * (topology.edges.EulerCharacteristic(mesh) + holes);
  if (sum != required)
  {
    throw Error("The indices of the field and of the boundary add up to " + std::to_string(sum) +
      " instead of " + std::to_string(required) +
      "; the field is not aligned with the boundary of its mesh, compute it again.");
  }
  std::sort(found.begin(), found.end(),
    [](const FieldSingularity& a, const FieldSingularity& b)
    {
      return std::make_tuple(a.place, a.position.x(), a.position.y()) <
        std::make_tuple(b.place, b.position.x(), b.position.y());
    });
  return found;
}
}
