#pragma once

#include "SeparationRow.h"

namespace crossfield
{
/// Minimum number of edges of a boundary loop of a mesh: with three, corners of quads at a round
/// hole would have 150° at least.
constexpr int MinimumLoop = 4;

/// A set of arcs at least one of which needs more edges.
struct Violation
{
  std::vector<int> arcs;
  /// Between the two points that coincide, or around a handle, from a point to itself; empty for a short loop.
  std::vector<PointLink> path;

  bool IsCycle() const { return !path.empty() && path.front().from == path.back().to; }
};

/// Returns the row that excludes a violation, for arcs of the given target counts. The row has no
/// terms if SeparateEnds gives none.
SeparationRow MakeSeparationRow(const Violation& violation, const TMesh& mesh,
  const std::vector<int>& counts, const std::vector<double>& target);

/// Returns the row of MakeSeparationRow if it excludes `counts` and holds for `best`, the best
/// counts known, whose displacements need not have the signs of the map. Otherwise returns a weaker
/// row, valid for all counts that keep the points apart: at least one arc of the path has an edge.
SeparationRow MakeSeparationRowFor(const std::vector<int>& best, const Violation& violation,
  const TMesh& mesh, const std::vector<int>& counts, const std::vector<double>& target);

/// Finds points that coincide but must not (docs/method.md §14.3): two cones or fixed nodes, a singularity and the
/// boundary, or points of the boundary that boundary arcs without edges do not join. There is one
/// violation per class of coincident points, with the arcs on the shortest path between two of
/// them, and one per boundary loop with fewer than MinimumLoop edges. On a surface with handles also one per class that
/// contains a path around a handle.
std::vector<Violation> FindViolations(const TMesh& mesh, const std::vector<int>& counts);
}
