#pragma once

#include "EdgeCounts.h"
#include "QuantisationProblem.h"
#include "SeparationRow.h"

namespace crossfield
{
/// Improves counts that satisfy all separation constraints: the arcs in a window of neighbouring
/// patches are free, all others fixed, and branch and cut solves the subproblem, window after
/// window, small ones first (docs/method.md §14.3). `largest` is the number of arcs of the largest
/// windows. Appends the generated separation rows to `rows`.
void ImproveInWindows(const TMesh& mesh, const QuantisationProblem& problem, std::size_t largest,
  EdgeCounts& best, std::vector<SeparationRow>& rows);
}
