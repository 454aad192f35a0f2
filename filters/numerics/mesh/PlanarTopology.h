#pragma once

#include "BoundaryCorners.h"
#include "MeshTopology.h"

namespace crossfield
{
/// A topology whose triangles lie in one plane.
struct PlanarTopology : MeshTopology
{
  /// Computes the derived data. Throws Error as NumberEdges and FindBoundaryLoops do.
  explicit PlanarTopology(TriangleMesh triangles);

  const Point& PointAt(int vertex) const { return mesh.points[vertex]; }
  Point Midpoint(int edge) const
  {
    const auto& [from, to] = edges.vertices[edge];
    return 0.5 * (PointAt(from) + PointAt(to));
  }
  /// Returns the mesh vertex of a corner of AlignedLoops.
  int VertexOf(const Corner& corner) const { return alignedVertices[corner.loop][corner.vertex]; }
  /// Returns the polygons of the aligned loops, with the domain on their left.
  std::vector<Loop> AlignedLoops() const;
  /// Returns an entry of mesh.boundary on the outer loop, where integration along edges starts.
  /// Throws Error if there is no outer loop.
  int FirstOuterEdge() const;
};

using SharedPlanarTopology = std::shared_ptr<const PlanarTopology>;

SharedPlanarTopology ShareTopology(TriangleMesh mesh);

/// Returns a topology as that of a planar mesh. Throws Error if it is another one.
SharedPlanarTopology RequirePlanar(const SharedTopology& topology);
}
