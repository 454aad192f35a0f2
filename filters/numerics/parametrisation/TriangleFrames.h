#pragma once

#include "PointPotential.h"

#include <array>
#include <vector>

namespace crossfield
{
/// H and a branch θ of the cross at the centre of every triangle, and the jumps between the
/// branches of neighbours (docs/method.md §12.1). H + iθ is analytic, so θ continued from one
/// triangle to the next through their common edge differs from the branch there by quarter turns.
/// With a holonomy defect these are the single-valued H and its conjugate, which deviates from the
/// direction of an inner loop by a quarter of the defect.
struct TriangleFrames
{
  /// A triangle near a singularity or corner, where e^{−(H + iθ)} is far from constant.
  struct NearLog
  {
    int triangle;
    LogSource log;
  };

  Eigen::VectorXd h;     ///< H, up to a constant.
  Eigen::VectorXd angle; ///< θ, radians.
  /// Per side i (p_i to p_i+1) of a triangle: θ continued across it minus the neighbour's θ, in
  /// units of π/2. On an aligned boundary edge: its direction minus θ, rounded to quarter turns.
  std::vector<std::array<int, 3>> jump;
  std::vector<NearLog> near; ///< Sorted by triangle, with the nearest logarithm.
  /// Largest deviation of the jumps between triangles from integral quarter turns, radians of θ:
  /// rounding.
  double residual = 0.0;
};

/// Computes the frames of one configuration. Throws Error when a jump is not an integral number of
/// quarter turns.
TriangleFrames FrameTriangles(
  const PointPotential& potential, const PointPotential::Solution& solution);
}
