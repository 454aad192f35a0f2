#pragma once

#include "BoundarySides.h"
#include "MeshBoundary.h"
#include "QuantisationProblem.h"
#include "SeamlessMap.h"
#include "SidePrescription.h"
#include "TMesh.h"

#include <map>
#include <vector>

namespace crossfield
{
/// Edges around a smooth loop that show its shape: a circle loses 5 % of its area.
constexpr int EnoughEdges = 12;

/// Loops of the boundary without corners, such as circles: with the few edges that conformal sizes may
/// leave for one, it would become a square.
class SmoothLoops
{
public:
  /// Finds the loops without corners and without prescribed sides.
  SmoothLoops(const SeamlessMap& map, const MeshBoundary& curves, const BoundarySides& sides,
    const SidePrescriptions& prescribed, const TMesh& mesh);

  /// Finds those of a surface.
  SmoothLoops(const MeshTopology& topology, const TMesh& mesh);

  /// Raises the targets of loops to which counts give fewer than twelve edges to this number, or to that of edges a
  /// quarter as long as the quads of a size if this is smaller, and their weights, so that the edge counts
  /// follow. Returns whether there are such loops.
  bool RaiseTargets(
    double size, const std::vector<int>& counts, QuantisationProblem& problem) const;

private:
  struct Loop
  {
    std::vector<int> arcs;
    double length = 0.0; ///< In the plane, or along the edges of a surface.
  };

  static std::map<int, Loop> LoopsOf(const TMesh& mesh);

  std::vector<Loop> Loops;
};
}
