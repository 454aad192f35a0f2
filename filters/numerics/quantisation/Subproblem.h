#pragma once

#include "BranchAndCut.h"
#include "EdgeCounts.h"
#include "QuantisationProblem.h"
#include "SeparationRow.h"

namespace crossfield
{
/// Searches for cheaper counts than `best`, which satisfy all separation constraints, by branch and
/// cut: only the arcs `free` are variables (docs/method.md §14.3). Starts with those of `rows` that
/// hold for `best` and contain a free arc, and appends the rows that it generates.
///
/// Returns the cheapest counts found, those of `best` if none is cheaper. `bound` is valid for all
/// counts that satisfy the rows and agree with `best` on the other arcs. `rootRelaxation`, if
/// given, receives the relaxed counts at the root, or nothing if the search ended there.
EdgeCounts SolveSubproblem(const TMesh& mesh, const QuantisationProblem& problem,
  const std::vector<int>& free, const BranchLimits& limits, const EdgeCounts& best,
  std::vector<SeparationRow>& rows, std::vector<double>* rootRelaxation = nullptr);

/// Replaces counts and cost of `best` by those of `found` if these cost less. Returns whether they
/// do.
bool ReplaceIfCheaper(EdgeCounts& best, EdgeCounts found);
}
