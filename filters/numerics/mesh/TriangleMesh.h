#pragma once

#include "BoundaryKind.h"
#include "Plane.h"

#include <array>

namespace crossfield
{
/// Directed edge of the mesh with the domain on its left.
struct BoundaryEdge
{
  std::array<int, 2> vertices{};
  BoundaryKind kind = BoundaryKind::Outer;
  int id = 0;           ///< Loop number; for holes and circles, the row of the configuration.
  int quarterIndex = 0; ///< Quarter index prescribed on holes and circles, otherwise 0.

  /// Returns whether the edge is on the outer or an inner loop, where crosses follow the boundary.
  bool IsAligned() const { return kind == BoundaryKind::Outer || kind == BoundaryKind::Inner; }
};

/// Conforming triangulation of a planar domain with counter-clockwise triangles.
struct TriangleMesh
{
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<BoundaryEdge> boundary;
  /// Edges of circles that are imprinted rather than drilled (docs/method.md §3.7, variants 4 and
  /// 5). They are interior edges and stored separately, so that they are not taken for boundary
  /// edges. The outside of the circle is on their left, like the domain at a hole.
  std::vector<BoundaryEdge> imprinted;
};
}
