#pragma once

#include "ArcProblem.h"

namespace crossfield
{
/// Counts that make blocks of a coarse solution: opposite edges of its quads belong to one chord, and every chord gets one
/// number m ≥ 1, so that arc a gets Σ m over its coarse edges and arcs of no edges keep none. m is the mean of what its
/// edges want, ℓ_a / n_a, by their weights, rounded (docs/method.md §14.9).
class Chords
{
public:
  Chords(const TMesh& mesh, std::vector<int> coarse);

  int Count() const { return this->Total; }
  std::vector<int> Refine(const ArcProblem& problem) const;

private:
  std::vector<int> Coarse;
  std::vector<std::vector<int>> OfArc; ///< The chords of its edges, along half-edge 2a.
  int Total = 0;
};
}
