#pragma once

#include "BoundaryCorners.h"
#include "EdgeNumbering.h"

#include <Eigen/Core>

#include <memory>

namespace crossfield
{
/// A triangle mesh with everything that follows from it alone: computed once, never changed, and shared
/// by the factor, the fields and the reports of the mesh. "Aligned" are the edges and vertices of outer
/// and inner loops, where crosses follow the boundary; the others of the boundary are those of holes.
struct MeshTopology
{
  /// Throws Error as NumberEdges and FindBoundaryLoops do.
  explicit MeshTopology(TriangleMesh triangles);

  TriangleMesh mesh;
  EdgeNumbering edges;
  std::vector<BoundaryLoop> loops;     ///< Outer, inner, holes.
  std::vector<BoundaryLoop> imprinted; ///< Imprinted circles.

  /// Per entry of mesh.boundary the entry that ends where it starts,
  std::vector<int> previous;
  /// and the angle in (−π, π] by which the boundary turns there, radians.
  Eigen::VectorXd turning;

  /// The vertices of each aligned loop, walked with the domain on the left.
  std::vector<std::vector<int>> alignedVertices;
  /// Of every vertex: whether it is a corner of an aligned loop (IsCorner with the default angle).
  std::vector<bool> corners;

  const Point& PointAt(int vertex) const { return mesh.points[static_cast<std::size_t>(vertex)]; }
  const BoundaryEdge& BoundaryAt(int position) const
  {
    return mesh.boundary[static_cast<std::size_t>(position)];
  }
  /// The edge of the mesh that an entry of mesh.boundary is.
  int EdgeOfBoundary(int position) const
  {
    return edges.ofBoundary[static_cast<std::size_t>(position)];
  }
  Point Midpoint(int edge) const
  {
    const auto& [from, to] = edges.vertices[static_cast<std::size_t>(edge)];
    return 0.5 * (PointAt(from) + PointAt(to));
  }
  /// The mesh vertex of a corner of AlignedLoops.
  int VertexOf(const Corner& corner) const
  {
    return alignedVertices[static_cast<std::size_t>(corner.loop)]
                          [static_cast<std::size_t>(corner.vertex)];
  }

  /// The polygons of the aligned loops, with the domain on their left.
  std::vector<Loop> AlignedLoops() const;
  /// Number of loops of a kind.
  Eigen::Index LoopCount(BoundaryKind kind) const;
  /// An entry of mesh.boundary on the outer loop, where integration along edges starts. Throws Error
  /// when there is no outer loop.
  int FirstOuterEdge() const;
};

using SharedTopology = std::shared_ptr<const MeshTopology>;

SharedTopology ShareTopology(TriangleMesh mesh);
}
