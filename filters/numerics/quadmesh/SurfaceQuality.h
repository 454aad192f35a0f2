#pragma once

#include "Plane.h"

namespace crossfield
{
/// How well quads fit the surface that they are on (docs/method.md §22.8).
struct SurfaceQuality
{
  /// Minimum over all corners of the sine of the angle, seen along the normal of the surface at the quad.
  double minimumJacobian = 1.0;
  double meanDistance = 0.0; ///< Of the centres of quads from the surface.
  double maximumDistance = 0.0;
  /// Number of quads at whose corners normals of the surface differ by more than 60°: they are larger than its radius
  /// of curvature, or across a sharp edge.
  int bent = 0;
  SpacePoint mostBent = SpacePoint::Zero(); ///< Centre of the quad whose normals differ most.
};
}
