#pragma once

#include "Plane.h"

#include <array>

namespace crossfield
{
/// What a marked edge of a drilled mesh is part of; the codes of the array `BoundaryKind`.
enum class BoundaryKind
{
  Outer = 1,
  Inner = 2,
  Hole = 3,
  ImprintedCircle = 4
};

/// A directed edge of the mesh with the domain on its left.
struct BoundaryEdge
{
  std::array<int, 2> vertices{};
  BoundaryKind kind = BoundaryKind::Outer;
  int id = 0;           ///< Loop number; for holes and circles the row of the configuration.
  int quarterIndex = 0; ///< Prescribed on holes and circles, else 0.

  /// On the outer or an inner loop, where crosses follow the boundary.
  bool IsAligned() const { return kind == BoundaryKind::Outer || kind == BoundaryKind::Inner; }
};

/// A conforming triangulation of a planar domain, triangles counter-clockwise.
struct TriangleMesh
{
  std::vector<Point> points;
  std::vector<std::array<int, 3>> triangles;
  std::vector<BoundaryEdge> boundary;
  /// Edges of circles that are imprinted and not drilled (docs/method.md §3.7, variants 4 and 5). They are
  /// interior edges, kept apart so that nothing takes them for boundary; the outside of the circle is
  /// on their left, as the domain is at a hole.
  std::vector<BoundaryEdge> imprinted;
};
}
