#pragma once

#include "BoundaryCorners.h"
#include "EdgeNumbering.h"

#include <Eigen/Core>

#include <memory>

namespace crossfield
{
/// Triangle mesh with all data derived from it alone. It is computed once, never changes, and is
/// shared by the factor, the fields and the reports of the mesh.
///
/// Edges and vertices of outer and inner loops are called aligned, because crosses follow the
/// boundary there. The other boundary edges and vertices are those of holes.
struct MeshTopology
{
  /// Computes the derived data. Throws Error as NumberEdges and FindBoundaryLoops do.
  explicit MeshTopology(TriangleMesh triangles);

  TriangleMesh mesh;
  EdgeNumbering edges;
  std::vector<BoundaryLoop> loops;     ///< Outer loop, inner loops, holes.
  std::vector<BoundaryLoop> imprinted; ///< Imprinted circles.

  /// For each entry of mesh.boundary, the entry that ends where it starts.
  std::vector<int> previous;
  /// For each entry of mesh.boundary, the angle in (−π, π] by which the boundary turns at its
  /// start, in radians.
  Eigen::VectorXd turning;

  /// Vertices of each aligned loop, in the order with the domain on the left.
  std::vector<std::vector<int>> alignedVertices;
  /// For each vertex, whether it is a corner of an aligned loop (IsCorner with the default angle).
  std::vector<bool> corners;

  const Point& PointAt(int vertex) const { return mesh.points[static_cast<std::size_t>(vertex)]; }
  const BoundaryEdge& BoundaryAt(int position) const
  {
    return mesh.boundary[static_cast<std::size_t>(position)];
  }
  /// Returns the mesh edge of an entry of mesh.boundary.
  int EdgeOfBoundary(int position) const
  {
    return edges.ofBoundary[static_cast<std::size_t>(position)];
  }
  Point Midpoint(int edge) const
  {
    const auto& [from, to] = edges.vertices[static_cast<std::size_t>(edge)];
    return 0.5 * (PointAt(from) + PointAt(to));
  }
  /// Returns the mesh vertex of a corner of AlignedLoops.
  int VertexOf(const Corner& corner) const
  {
    return alignedVertices[static_cast<std::size_t>(corner.loop)]
                          [static_cast<std::size_t>(corner.vertex)];
  }

  /// Returns the polygons of the aligned loops, with the domain on their left.
  std::vector<Loop> AlignedLoops() const;
  /// Returns the number of loops of a kind.
  Eigen::Index LoopCount(BoundaryKind kind) const;
  /// Returns an entry of mesh.boundary on the outer loop, where integration along edges starts.
  /// Throws Error if there is no outer loop.
  int FirstOuterEdge() const;
};

using SharedTopology = std::shared_ptr<const MeshTopology>;

SharedTopology ShareTopology(TriangleMesh mesh);
}
