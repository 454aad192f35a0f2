#pragma once

#include "EdgeNumbering.h"

namespace crossfield
{
/// Shortest chain of triangles from the outer loop to an inner loop or hole: the cut across which a
/// multivalued potential jumps (docs/method.md §2.3, islands).
struct LoopStrip
{
  int firstBoundaryEdge = 0; ///< Index into mesh.boundary of the outer edge where the strip starts.
  /// Index into mesh.boundary of the edge of the other loop where the strip ends.
  int lastBoundaryEdge = 0;
  struct Step
  {
    int triangle;
    /// 1 at the triangle's vertices to the left of the path from the first to the last edge, else
    /// 0.
    std::array<double, 3> left;
  };
  std::vector<Step> steps;
};

/// Finds one strip per inner loop and, if `withHoles` is set, one per hole, in the order of the
/// loops.
std::vector<LoopStrip> FindLoopStrips(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const std::vector<BoundaryLoop>& loops, bool withHoles);
}
