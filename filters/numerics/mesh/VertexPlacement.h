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

/// Makes vertices of a surface at points on it, one for each (docs/method.md §22.6).
class VertexPlacement
{
public:
  /// The surface must outlive the object. Throws Error as FindNeighbours does.
  explicit VertexPlacement(SurfaceMesh& surface);

  struct Placed
  {
    int vertex = -1;
    double distance = 0.0; ///< Of the vertex from the point: 0 if there could be one.
  };

  /// Returns a vertex at a point of a triangle: the nearest corner of it that is neither on the boundary nor at a sharp
  /// edge nor taken and that can move there without angles below 8° or triangles turned over; or a new one that divides
  /// the triangle, if that leaves no such angles; or else the nearest corner where it is. Nothing if then all corners
  /// are on the boundary or taken.
  std::optional<Placed> Place(const SurfacePoint& point);

private:
  bool CanMove(int vertex, const SpacePoint& to) const;
  /// Returns whether an edge at a vertex has triangles in clearly different planes.
  bool IsSharp(int vertex) const;
  /// Returns the triangle with a side from one vertex to another, −1 on the boundary.
  int TriangleWith(int from, int to) const;
  /// The other diagonal of the quadrilateral of a triangle and that across a side of it.
  struct Diagonal
  {
    int triangle = -1; ///< Across the side, −1 on the boundary.
    int beyond = -1;   ///< Its third vertex.
    double angle =
      0.0; ///< Smallest angle of both triangles with it; 0 if there is no such diagonal in their plane.
  };
  /// Returns that of a triangle with a side and a vertex at a place.
  Diagonal DiagonalAcross(int from, int to, const SpacePoint& place) const;
  /// Divides a triangle at a point in it, with other diagonals in the planes of its neighbours where angles are larger.
  /// Returns the new vertex, −1 if triangles would be too thin.
  int Divide(const SurfacePoint& point);
  /// Sets the vertices of a triangle.
  void Set(int triangle, const std::array<int, 3>& vertices);

  SurfaceMesh& Surface;
  std::vector<std::vector<int>> TrianglesAt; ///< Per vertex.
  std::vector<bool> IsFree;                  ///< Per vertex: inside and not taken.
};
}
