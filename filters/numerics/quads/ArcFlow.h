#pragma once

#include "ArcProblem.h"

namespace crossfield
{
/// The optimum of an ArcProblem over half-integers, which is that over the reals.
struct RelaxedCounts
{
  bool feasible = false;
  std::vector<int> doubled; ///< 2 n_a.
  double cost = 0.0;
};

/// One minimum cost flow in the double cover (docs/method.md §14.2). `upper` −1 stands for no bound.
RelaxedCounts SolveRelaxedCounts(
  const ArcProblem& problem, const std::vector<int>& lower, const std::vector<int>& upper);

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
