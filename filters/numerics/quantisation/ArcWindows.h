#pragma once

#include "ArcFlow.h"
#include "Progress.h"
#include "SeparationRow.h"

namespace crossfield
{
/// Better counts than those given, which keep everything apart: the arcs in a window of the T-mesh are free, all others stay
/// as they are, and branch and cut finds the best; one window after the other, small ones first (docs/method.md §14.3). `largest` is
/// the number of arcs of the largest ones. Rows that were found on the way are added to `rows`.
void ImproveInWindows(const TMesh& mesh, const ArcProblem& problem, std::size_t largest,
  IntegerCounts& best, std::vector<ArcRow>& rows, const Progress& progress = {});
}
