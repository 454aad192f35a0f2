#pragma once

#include "Cycle.h"

#include <Eigen/Core>

#include <memory>
#include <optional>

namespace crossfield
{
/// An isometric chart for each triangle: places of its corners in a plane of its own, and how the
/// planes of neighbours are turned against each other.
struct TriangleCharts
{
  std::vector<SpacePoint> positions;         ///< Of the vertices, in space.
  std::vector<std::array<Point, 3>> corners; ///< Counter-clockwise.
  /// Per side of a triangle: direction a in its chart is a + hinge in that of the neighbour, radians;
  /// 0 on the boundary.
  std::vector<std::array<double, 3>> hinges;
  /// Per vertex inside, 2π minus the sum of the angles of its triangles; 0 on the boundary.
  Eigen::VectorXd curvature;
};

/// Triangle mesh with all data derived from it alone. It is computed once, never changes, and is
/// shared by the factor, the fields and the reports of the mesh.
///
/// It has lengths and angles, but no common frame of its triangles: what needs one takes a
/// PlanarTopology.
///
/// Edges and vertices of outer and inner loops are called aligned, because crosses follow the
/// boundary there. The other boundary edges and vertices are those of holes.
struct MeshTopology
{
  /// Its points are not numbers if the mesh is not planar: use charts, or PositionOf.
  TriangleMesh mesh;
  /// None if the mesh is planar: the plane is the chart of every triangle.
  std::optional<TriangleCharts> charts;
  EdgeNumbering edges;
  std::vector<BoundaryLoop> loops;     ///< Outer loop, inner loops, holes.
  std::vector<BoundaryLoop> imprinted; ///< Imprinted circles.
  std::vector<Cycle> cycles;           ///< Those of FindCycles.

  /// For each entry of mesh.boundary, the entry that ends where it starts.
  std::vector<int> previous;
  /// For each entry of mesh.boundary, the angle in (−π, π] by which the boundary turns at its
  /// start, in radians.
  Eigen::VectorXd turning;

  /// Vertices of each aligned loop, in the order with the domain on the left.
  std::vector<std::vector<int>> alignedVertices;
  /// For each vertex, whether it is a corner of an aligned loop (IsCorner with the default angle).
  std::vector<bool> corners;

  virtual ~MeshTopology() = default;

  int VertexCount() const { return static_cast<int>(mesh.points.size()); }
  int TriangleCount() const { return static_cast<int>(mesh.triangles.size()); }
  const BoundaryEdge& BoundaryAt(int position) const { return mesh.boundary[position]; }
  /// Returns the mesh edge of an entry of mesh.boundary.
  int EdgeOfBoundary(int position) const { return edges.ofBoundary[position]; }
  /// Returns the number of loops of a kind.
  Eigen::Index LoopCount(BoundaryKind kind) const;

  int Neighbour(int triangle, int side) const { return edges.Neighbour(triangle, side); }
  int EdgeOf(int triangle, int side) const { return edges.ofTriangle[triangle][side]; }
  int SideOf(int triangle, int edge) const { return edges.SideOf(triangle, edge); }
  /// Returns the triangle and its side at an entry of mesh.boundary.
  std::pair<int, int> SideOfBoundary(int position) const;

  /// Returns the place of a corner in the chart of a triangle.
  const Point& At(int triangle, int corner) const
  {
    const auto t = static_cast<std::size_t>(triangle);
    const auto i = static_cast<std::size_t>(corner);
    return charts ? charts->corners[t][i] : mesh.points[mesh.triangles[t][i]];
  }
  std::array<Point, 3> ChartOf(int triangle) const
  {
    return { At(triangle, 0), At(triangle, 1), At(triangle, 2) };
  }
  Point CentreOf(int triangle) const
  {
    return (At(triangle, 0) + At(triangle, 1) + At(triangle, 2)) / 3.0;
  }
  /// Returns the angle from the chart of a triangle to that across a side: 0 in the plane.
  double Hinge(int triangle, int side) const
  {
    return charts ? charts->hinges[triangle][side] : 0.0;
  }
  /// Returns the midpoint of a side of a triangle, in its chart.
  Point MiddleOf(int triangle, int side) const
  {
    return 0.5 * (At(triangle, side) + At(triangle, (side + 1) % 3));
  }
  /// Returns the direction of a side of a triangle in its chart, with the triangle on its left, in radians.
  double DirectionOf(int triangle, int side) const;
  double Length(int edge) const;
  double AreaOf(int triangle) const;
  /// Returns the area of all triangles.
  double Area() const;
  /// Returns the unit normal of a triangle in space; in the plane along z.
  SpacePoint NormalOf(int triangle) const;
  /// Returns 2π minus the sum of the angles at a vertex inside: 0 in the plane.
  double CurvatureAt(int vertex) const { return charts ? charts->curvature[vertex] : 0.0; }
  /// Returns the position of a vertex: its point in the plane, with z = 0.
  SpacePoint PositionOf(int vertex) const
  {
    return charts ? charts->positions[vertex] : InSpace(mesh.points[vertex]);
  }
  /// Returns the position of a vertex, for messages.
  std::string Where(int vertex) const
  {
    return charts ? DescribeInSpace(charts->positions[vertex]) : Describe(mesh.points[vertex]);
  }

protected:
  /// Computes the derived data without angles, and cycles if the mesh is connected. Throws Error as NumberEdges and
  /// FindBoundaryLoops do.
  explicit MeshTopology(TriangleMesh triangles, bool isConnected = true);
};

using SharedTopology = std::shared_ptr<const MeshTopology>;
}
