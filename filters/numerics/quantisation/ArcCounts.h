#pragma once

#include "ArcProblem.h"
#include "Progress.h"

namespace crossfield
{
/// The numbers of edges of all arcs, and how good they are.
struct ArcCounts
{
  std::vector<int> counts;
  int zeroArcs = 0;
  double cost = 0.0;    ///< Σ w |n − ℓ|.
  double bound = 0.0;   ///< Of the cost: proved by branch and cut with rows that keep points apart.
  double gap = 0.0;     ///< (cost − bound) / (1 + bound).
  bool optimal = false; ///< The gap is proved to be zero.
  int nodes = 0;        ///< Of branch and cut.
  double seconds = 0.0;
};

/// How long an optimum is looked for: Quick is for numbers of which one is chosen.
enum class ArcSearch
{
  Quick,
  Thorough
};

/// The flow, where that joins nothing. Else numbers n ≥ 1, which never do, are improved in windows (ArcWindows.h) and by branch
/// and cut of the whole problem with rows that keep points apart, as far as a number of nodes goes (docs/method.md §14.3).
ArcCounts CountArcs(
  const TMesh& mesh, const ArcProblem& problem, ArcSearch search, const Progress& progress = {});
}
