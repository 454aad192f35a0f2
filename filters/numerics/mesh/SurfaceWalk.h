#pragma once

#include "MeshTopology.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// A point of a triangulation, in the chart of a triangle.
struct MeshPlace
{
  int triangle = -1;
  Point at = Point::Zero();
};

/// Two orthogonal unit vectors in space, as columns.
using TangentAxes = Eigen::Matrix<double, 3, 2>;

/// Returns unit vectors orthogonal to a unit normal and to each other, counter-clockwise around it.
TangentAxes AxesOf(const SpacePoint& normal);

/// Straight paths on a triangulated surface (docs/method.md §22.8), which cross an edge as in the plane in which both
/// of its triangles lie once one is turned about the edge; and unit normals that are continuous: at a vertex the mean
/// of those of its triangles weighted with their angles, linear between vertices.
class SurfaceWalk
{
public:
  /// The topology must outlive the object.
  explicit SurfaceWalk(const MeshTopology& topology);

  /// Returns the point nearest to a place in space of those around a triangle: that of a place in it.
  MeshPlace Find(int triangle, const SpacePoint& place) const
  {
    return this->Approach({ triangle, this->Topology.CentreOf(triangle) }, place);
  }
  SpacePoint PlaceOf(const MeshPlace& place) const;
  SpacePoint NormalAt(const MeshPlace& place) const;

  /// Returns the end of a straight path whose direction is that of `step` in the plane of its first triangle, and
  /// whose length is that of `step`. It ends early at the boundary. Throws Error if it does not end.
  MeshPlace Walk(MeshPlace from, const SpacePoint& step) const;

  /// Returns the point nearest to a place in space of those around a point, by a few walks towards it.
  MeshPlace Approach(MeshPlace from, const SpacePoint& place) const;

private:
  /// Returns the linear interpolation of values at the vertices.
  template <typename AtVertex>
  SpacePoint Interpolate(const MeshPlace& place, const AtVertex& atVertex) const;
  /// Returns the axes of the chart of a triangle in space.
  TangentAxes FrameOf(int triangle) const;

  const MeshTopology& Topology;
  std::vector<SpacePoint> Normals; ///< At the vertices.
};
}
