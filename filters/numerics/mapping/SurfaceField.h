#pragma once

#include "Progress.h"
#include "SeamlessMap.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// H and the crosses of singularities and corners at vertices of a surface (docs/method.md §22.2).
struct SurfaceField
{
  /// Per vertex; its mean over the area is 0. Finite at singularities, where H is not.
  Eigen::VectorXd h;
  Eigen::VectorXd angle;         ///< Per triangle, θ in its chart, radians.
  std::vector<SpacePoint> cross; ///< Per triangle, the direction of θ in space, a unit vector.
  std::vector<double> holonomyDefect; ///< Of inner loops and handles, radians.
};

/// Solves for the field of cones. On a closed surface crosses have the angle of the map (docs/method.md §22.4).
/// Throws Error as SolveSurfaceFrames does.
SurfaceField SolveSurfaceField(
  const SharedTopology& topology, const std::vector<Cone>& cones, const Progress& progress = {});
}
