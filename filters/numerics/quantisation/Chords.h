#pragma once

#include "QuantisationProblem.h"

namespace crossfield
{
/// The chords of a coarse solution: rows of quads from boundary to boundary, or closed. A
/// refinement gives each chord one number m ≥ 1 of edges, so arc a gets Σ m over its coarse edges,
/// arcs without edges keep none, and the blocks are those of the coarse solution. m is the weighted
/// mean of ℓ_a / n_a over the edges of the chord, rounded (docs/method.md §14.9).
class Chords
{
public:
  Chords(const TMesh& mesh, std::vector<int> coarse);

  int Count() const { return this->Total; }
  /// Returns the refined counts for the targets of a problem, nearest to them with the prescribed
  /// sums; none if the chords cannot have these.
  std::vector<int> Refine(const QuantisationProblem& problem) const;

private:
  /// Returns the number of edges of each chord; none if the prescribed sums are not possible.
  std::vector<int> Numbers(const QuantisationProblem& problem) const;

  std::vector<int> Coarse;
  std::vector<std::vector<int>> OfArc; ///< Chords of the edges of each arc, along half-edge 2a.
  int Total = 0;
};
}
