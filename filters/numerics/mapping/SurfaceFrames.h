#pragma once

#include "Progress.h"
#include "SeamlessMap.h"
#include "TriangleFrames.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// H and crosses of cones at vertices of a surface.
struct SurfaceFrames
{
  Eigen::VectorXd h; ///< Per vertex, up to a constant.
  TriangleFrames frames;
  std::vector<double> holonomyDefect; ///< As in VertexPotential::Solution.
};

/// Solves for the potential of cones and continues its phase over the triangles (docs/method.md §22.2, §22.5). Throws
/// Error as VertexPotential and FrameTriangles do.
SurfaceFrames SolveSurfaceFrames(
  const SharedTopology& topology, const std::vector<Cone>& cones, const Progress& progress = {});
}
