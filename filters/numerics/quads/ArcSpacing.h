#pragma once

#include "TMesh.h"

namespace crossfield
{
/// Returns for every arc of a T-mesh the n_a + 1 distances from its start, in the map, of the
/// points that divide it into its n_a edges, or its one edge if n_a is 0 (docs/method.md §14.4).
std::vector<std::vector<double>> EqualSpacing(const TMesh& mesh, const std::vector<int>& counts);

/// Works as EqualSpacing, but lengths of edges change gradually beside arcs with prescribed numbers
/// of edges, as behind the trailing edge of a profile. A strip is a sequence of quads through
/// opposite edges. Its width is the geometric mean of L_a / n_a over the edges on arcs, limited to
/// 1.2^−d to 1.2^d times that of each strip through a prescribed arc, with d − 1 strips between.
/// The factors by which this changes widths are then fitted so that their mean on each arc is 1,
/// and each arc is divided in proportion to those of its strips. Cost: n log n in the edges on
/// arcs.
std::vector<std::vector<double>> GradualSpacing(
  const TMesh& mesh, const std::vector<int>& counts, const std::vector<int>& prescribed);
}
