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
  double cost = 0.0;  ///< Σ w |n − ℓ|.
  double bound = 0.0; ///< Of the cost: proved by branch and bound with rows that keep points apart.
  double gap = 0.0;   ///< (cost − bound) / (1 + bound).
  bool optimal = false; ///< The gap is proved to be zero.
  int flows = 0;
  int nodes = 0; ///< Of branch and bound.
  double seconds = 0.0;
};

/// How long an optimum is looked for: Quick is for numbers of which one is chosen.
enum class ArcSearch
{
  Quick,
  Thorough
};

/// Solves the flow, finds points that must not be one, bounds one arc of each way between them, the
/// one with which the flow's cost rises least, and starts again (docs/method.md §14.3). Then bounds that are
/// needed no more are dropped. Ends always: with n ≥ 1 everywhere nothing is joined. Then the optimum is looked
/// for by branch and cut, with rows instead of bounds, as far as a number of nodes goes.
ArcCounts CountArcs(
  const TMesh& mesh, const ArcProblem& problem, ArcSearch search, const Progress& progress = {});
}
