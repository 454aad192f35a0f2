#pragma once

#include "EdgeNumbering.h"

namespace crossfield
{
/// A shortest chain of triangles from the outer loop to an inner loop or hole: the cut across which
/// a multivalued potential jumps (docs/method.md §2.3, islands).
struct LoopStrip
{
  int firstBoundaryEdge = 0; ///< Position in mesh.boundary of the outer edge where it starts,
  int lastBoundaryEdge = 0;  ///< and of the edge of the other loop where it ends.
  struct Step
  {
    int triangle;
    /// 1 at the triangle's vertices on the left of the way from the first to the last edge, else 0.
    std::array<double, 3> left;
  };
  std::vector<Step> steps;
};

/// One strip per inner loop, and one per hole if asked for, in the order of the loops.
std::vector<LoopStrip> FindLoopStrips(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const std::vector<BoundaryLoop>& loops, bool withHoles);
}
