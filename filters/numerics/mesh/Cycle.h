#pragma once

#include "EdgeNumbering.h"

#include <Eigen/Core>

namespace crossfield
{
/// Strip of triangles, each behind a side of the one before: the cut across which a multivalued
/// function jumps (docs/method.md §2.3, islands).
struct Cycle
{
  struct Step
  {
    int triangle;
    int entry; ///< Side through which the strip enters.
    int exit;  ///< Side through which it leaves.

    /// Returns the cut function at the corners of the triangle: 1 on the left of the path along the
    /// strip, 0 on its right.
    Eigen::Vector3d Left() const;
  };
  /// Without ends, the last step leaves to the first one.
  std::vector<Step> steps;
  /// Indices into mesh.boundary of the edge of the outer loop where the strip starts, and of the
  /// edge of another loop where it ends; −1 if the strip is closed.
  int firstBoundaryEdge = -1;
  int lastBoundaryEdge = -1;

  bool IsClosed() const { return this->firstBoundaryEdge < 0; }
};

/// Returns strips that generate all cycles of a connected mesh relative to its boundary: the shortest
/// one from the outer loop (the first loop, if none is outer) to every other loop, in their order, and
/// then 2g closed ones for a surface of genus g. Throws Error if a loop cannot be reached.
std::vector<Cycle> FindCycles(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const std::vector<BoundaryLoop>& loops);
}
