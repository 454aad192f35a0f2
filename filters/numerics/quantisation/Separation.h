#pragma once

#include "SeparationRow.h"

namespace crossfield
{
/// A loop of a mesh has three edges at least, as a boundary of less is no polygon.
constexpr int LeastLoop = 3;

/// Arcs of which one at least must get more edges.
struct Violation
{
  std::vector<int> arcs;
  std::vector<PointLink> way; ///< Between the two points; empty for a loop.
};

/// What keeps a violation from happening again, of arcs of wanted lengths: a row without terms where that is none.
ArcRow RowOf(const Violation& violation, const TMesh& mesh, const std::vector<int>& counts,
  const std::vector<double>& wanted);

/// The same if it holds for the best numbers known, which need not have the signs of the map, else a weaker row that holds for all that
/// keep the points apart: one arc of the way, at least, has an edge.
ArcRow RowAllowing(const std::vector<int>& best, const Violation& violation, const TMesh& mesh,
  const std::vector<int>& counts, const std::vector<double>& wanted);

/// What must not be one point but is (docs/method.md §14.3): two cones, a singularity and the boundary, points of the
/// boundary that no boundary arcs without edges join; one violation per class of points, with the arcs on the
/// shortest way in between. And boundary loops with less than three edges.
std::vector<Violation> FindViolations(const TMesh& mesh, const std::vector<int>& counts);
}
