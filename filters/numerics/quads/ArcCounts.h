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
  int forced = 0;       ///< Arcs with a bound that keeps points apart.
  double cost = 0.0;    ///< Σ w |n − ℓ|.
  double bound = 0.0;   ///< Of the flow: of the cost without keeping points apart.
  double gap = 0.0;     ///< (cost − bound) / (1 + bound).
  bool optimal = false; ///< The gap is proved to be zero.
  int flows = 0;
  double seconds = 0.0;
};

/// Solves the flow, finds points that must not be one, bounds one arc of each way between them, the
/// one with which the flow's cost rises least, and starts again (docs/method.md §14.3). In the end bounds that are
/// needed no more are dropped. Ends always: with n ≥ 1 everywhere nothing is joined.
ArcCounts CountArcs(const TMesh& mesh, ArcProblem problem, const Progress& progress = {});
}
