#pragma once

#include "PointPotential.h"

#include <array>
#include <vector>

namespace crossfield
{
/// H and a branch θ of the cross at the centre of every triangle, with what is lost by taking a branch
/// (docs/method.md §12.1): H + iθ is analytic, so θ carried from one triangle to the next by the shortest
/// way through their edge differs from the branch there by quarter turns. With a holonomy defect these
/// are the single-valued H and its conjugate, which is off the direction of an inner loop by a quarter
/// of the defect.
struct TriangleFrames
{
  /// A triangle near a singularity or corner, where e^{−(H + iθ)} is far from constant.
  struct NearLog
  {
    int triangle;
    LogSource log;
  };

  Eigen::VectorXd h;     ///< Up to a constant.
  Eigen::VectorXd angle; ///< θ, radians.
  /// Across side i (p_i to p_i+1) of a triangle: θ carried over minus the neighbour's θ is `jump` π/2.
  /// On an aligned boundary edge: its direction minus θ, to the nearest quarter turn.
  std::vector<std::array<int, 3>> jump;
  std::vector<NearLog> near; ///< By triangle, with the nearest logarithm.
  /// Largest distance, radians of θ, of those between triangles from whole quarter turns: rounding.
  double residual = 0.0;
};

/// The frames of one configuration. Throws Error when a jump is no whole number of quarter turns.
TriangleFrames FrameTriangles(
  const PointPotential& potential, const PointPotential::Solution& solution);
}
