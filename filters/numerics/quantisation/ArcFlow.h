#pragma once

#include "ArcProblem.h"

namespace crossfield
{
struct IntegerCounts
{
  std::vector<int> counts;
  double cost = 0.0;
  double bound = 0.0; ///< Of the relaxation.
  bool optimal = false;
  int flows = 0;
};

/// Branch and bound on the arcs whose relaxed counts are half-integral. Where it ends before the proof, the best
/// that it found; at worst twice the relaxed solution, which is always allowed.
IntegerCounts SolveArcFlow(const ArcProblem& problem);
}
