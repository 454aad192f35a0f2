#pragma once

#include "SurfaceMesh.h"

#include <optional>
#include <vector>

namespace crossfield
{
/// The point of a surface nearest to a place.
struct SurfacePoint
{
  int triangle = -1;
  SpacePoint place = SpacePoint::Zero();
  double distance = 0.0; ///< From the place.
};

/// Returns the point of a segment nearest to a place.
SpacePoint NearestOnSide(const SpacePoint& from, const SpacePoint& to, const SpacePoint& place);

/// Returns the nearest point of a surface with at least one triangle. Cost: linear in triangles.
SurfacePoint FindNearest(const SurfaceMesh& surface, const SpacePoint& place);

/// Moves vertices of a surface to points on it, one vertex to each (docs/method.md §22.6).
class VertexPlacement
{
public:
  /// The surface must outlive the object. Throws Error as FindNeighbours does.
  explicit VertexPlacement(SurfaceMesh& surface);

  struct Placed
  {
    int vertex = -1;
    double distance = 0.0; ///< Of the vertex from the point: 0 if it could be moved there.
  };

  /// Returns a vertex at a point of a triangle: the nearest corner of it that is neither on the boundary nor
  /// taken and that can move there without angles below 8° or triangles turned over; if there is none, the
  /// nearest one where it is. Nothing if all corners are on the boundary or taken.
  std::optional<Placed> Place(const SurfacePoint& point);

private:
  bool CanMove(int vertex, const SpacePoint& to) const;

  SurfaceMesh& Surface;
  std::vector<std::vector<int>> TrianglesAt; ///< Per vertex.
  std::vector<bool> IsFree;                  ///< Per vertex: inside and not taken.
};
}
