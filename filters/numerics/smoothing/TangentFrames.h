#pragma once

#include "QuadMesh.h"
#include "SurfaceWalk.h"

namespace crossfield
{
/// Returns the index of the first of the two unknowns of a point.
inline Eigen::Index FirstUnknown(int point)
{
  return 2 * static_cast<Eigen::Index>(point);
}

/// Two coordinates for the points of a mesh: in the plane their positions, on a surface those in the tangent planes
/// at their places (docs/method.md §22.8). Each quad sees its points in a plane of its own, whose normal is the mean of
/// theirs: the tangent plane of a point is projected to it.
class TangentFrames
{
public:
  /// `surface` is null in the plane, otherwise it must outlive the object.
  TangentFrames(const QuadMesh& mesh, const SurfaceWalk* surface);

  /// Returns the coordinates of a place near a point.
  Point CoordinatesOf(int point, const SpacePoint& place) const
  {
    return this->Surface == nullptr
      ? Point(place.head<2>())
      : Point(this->Points[point].axes.transpose() * (place - this->Points[point].origin));
  }
  /// Returns the components of a vector in space at a point.
  Point ComponentsOf(int point, const SpacePoint& vector) const
  {
    return this->Surface == nullptr ? Point(vector.head<2>())
                                    : Point(this->Points[point].axes.transpose() * vector);
  }
  /// Returns the vector in space with components at a point.
  SpacePoint VectorOf(int point, const Point& components) const
  {
    return this->Surface == nullptr ? InSpace(components)
                                    : SpacePoint(this->Points[point].axes * components);
  }
  /// Returns the place of a corner with coordinates in the plane of its quad.
  Point InQuad(std::size_t quad, std::size_t corner, const Point& coordinates) const
  {
    return this->Surface == nullptr
      ? coordinates
      : Point(this->Quads[quad][corner].origin + this->Quads[quad][corner].turn * coordinates);
  }
  /// Returns the gradient with respect to coordinates from that with respect to InQuad.
  Point FromQuad(std::size_t quad, std::size_t corner, const Point& gradient) const
  {
    return this->Surface == nullptr ? gradient
                                    : Point(this->Quads[quad][corner].turn.transpose() * gradient);
  }

  /// Moves a point to coordinates, on a surface by a walk. Returns how far it is then from where its tangent plane
  /// has it: 0 in the plane.
  double Move(int point, const Point& coordinates, QuadPoint& moved) const;
  /// Moves a point to a place on the surface or in the plane.
  void MoveTo(int point, const SpacePoint& place, QuadPoint& moved) const;

private:
  struct PointFrame
  {
    MeshPlace place;
    SpacePoint origin;
    TangentAxes axes;
  };
  struct CornerFrame
  {
    Point origin;
    Eigen::Matrix2d turn;
  };

  const SurfaceWalk* Surface;
  std::vector<PointFrame> Points;                ///< Empty in the plane.
  std::vector<std::array<CornerFrame, 4>> Quads; ///< Empty in the plane.
};

/// Returns the normals of a surface at the points of quads, whose triangles are set.
std::vector<SpacePoint> NormalsAtPoints(const SurfaceWalk& surface, const QuadMesh& mesh);

/// Sets the normals of quads on a surface: the mean of those at their corners.
void SetNormals(const SurfaceWalk& surface, QuadMesh& mesh);
}
