#pragma once

#include "SurfaceTopology.h"
#include "SurfaceWalk.h"

#include <array>
#include <vector>

namespace crossfield
{
/// Where the points of a quad mesh of any program are on a surface. They may be beside it.
class QuadsOnSurface
{
public:
  /// Finds the triangle of one point of each connected part of the quads among all, and those of others from their
  /// neighbours': where sheets of the surface are close to each other, all are on the same one. Throws Error if the
  /// surface is not one connected part, and as FindSurfaceParts does.
  QuadsOnSurface(const SurfaceMesh& surface, const std::vector<SpacePoint>& points,
    const std::vector<std::array<int, 4>>& quads);
  QuadsOnSurface(const QuadsOnSurface&) = delete;
  QuadsOnSurface& operator=(const QuadsOnSurface&) = delete;

  const SurfaceWalk& Walk() const { return this->Paths; }
  /// Returns the triangle of a point, −1 if no quad has it.
  int TriangleOf(int point) const { return this->Triangles[point]; }
  /// Returns the point of the surface nearest to a place near a point.
  SpacePoint NearestTo(const SpacePoint& place, int point) const;
  /// Returns the point of the surface's boundary nearest to a place; the place if it has none. Cost: linear in edges of
  /// the boundary.
  SpacePoint NearestOnBoundary(const SpacePoint& place) const;
  /// Returns whether a place is on the surface's boundary, up to a distance.
  bool IsOnBoundary(const SpacePoint& place, double distance) const;
  /// Returns the lines of the surface as pairs of ends: its boundary and the edges sharper than an angle, in radians
  /// (FindFeatureEdges).
  std::vector<std::array<SpacePoint, 2>> FindLines(double featureAngle) const;

private:
  const SurfaceMesh Surface;
  const SurfaceTopology Topology;
  const SurfaceWalk Paths;
  std::vector<int> Triangles;
};
}
