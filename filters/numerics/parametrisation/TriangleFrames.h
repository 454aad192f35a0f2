#pragma once

#include "MeshTopology.h"

#include <array>
#include <vector>

namespace crossfield
{
/// A triangle near a cone, where e^{−(H + iθ)} is far from constant: its integral is ζ^power up to a
/// constant, ζ the position minus that of the cone.
struct NearCone
{
  int triangle;
  Point position; ///< Of the cone, in the chart of the triangle.
  double power;
};

/// What the frames of triangles are made of, whatever the cross field was solved with.
struct PhaseSteps
{
  Eigen::VectorXd centre; ///< 4H at the centres of triangles, up to a constant.
  /// Per side of a triangle, the increase of the phase 4θ from the centre to the midpoint of the side.
  std::vector<std::array<double, 3>> toSide;
  /// Per entry of mesh.boundary, the phase at its midpoint minus 4 times the direction of the edge.
  Eigen::VectorXd boundaryShift;
  std::vector<NearCone> near; ///< Sorted by triangle, with the nearest cone.
};

/// H and a branch θ of the cross at the centre of every triangle, relative to its chart, and the jumps
/// between the branches of neighbours (docs/method.md §12.1). H + iθ is analytic, so θ continued from
/// one triangle to the next through their common edge differs from the branch there by quarter turns.
/// With a holonomy defect these are the single-valued H and its conjugate, which deviates from the
/// direction of an inner loop by a quarter of the defect.
struct TriangleFrames
{
  Eigen::VectorXd h;     ///< H, up to a constant.
  Eigen::VectorXd angle; ///< θ, radians.
  /// Per side i (p_i to p_i+1) of a triangle: θ continued across it minus the neighbour's θ, in
  /// units of π/2. On an aligned boundary edge: its direction minus θ, rounded to quarter turns.
  std::vector<std::array<int, 3>> jump;
  std::vector<NearCone> near; ///< As in PhaseSteps.
  /// Largest deviation of the jumps between triangles from integral quarter turns, radians of θ:
  /// rounding.
  double residual = 0.0;
};

/// Continues the phase from triangle to triangle. Throws Error when a jump is not an integral number
/// of quarter turns.
TriangleFrames FrameTriangles(const MeshTopology& topology, PhaseSteps steps);
}
