#pragma once

#include "ArcFlow.h"
#include "SeparationRow.h"

namespace crossfield
{
struct Improvement
{
  bool isBetter = false;
  double bound = 0.0; ///< No counts with these rows, and with those that do not change, cost less.
  int nodes = 0;
  std::vector<double> relaxed; ///< Counts over the reals; empty where none were needed.
};

/// Better counts than `best`, which keep everything apart, by branch and cut: only the arcs `free` change
/// (docs/method.md §14.3). Begins with the rows that hold for `best`, and adds those that it meets to `rows`.
Improvement ImproveCounts(const TMesh& mesh, const ArcProblem& problem,
  const std::vector<int>& free, int mostNodes, IntegerCounts& best, std::vector<ArcRow>& rows);
}
