#pragma once

#include "BoundaryCurves.h"
#include "PairedSides.h"
#include "QuantisationProblem.h"
#include "TMesh.h"

#include "SeamlessMap.h"

#include <string>
#include <vector>

namespace crossfield
{
/// Adds nodes to a T-mesh at the ends of paired sides, at the corners on them, and at the images of these
/// corners on the other side, so that quads have nodes there.
void SplitAtPairs(const SeamlessMap& map, const BoundaryCurves& curves, const BoundarySides& sides,
  const std::vector<PairedSides>& pairs, TMesh& mesh);

/// The arcs of each part between these nodes, for a T-mesh that is split there.
class PairedArcs
{
public:
  PairedArcs(const SeamlessMap& map, const BoundaryCurves& curves, const BoundarySides& sides,
    const std::vector<PairedSides>& pairs, const TMesh& mesh);

  /// Adds the equations that make the edge counts of both sides of each pair, and of their parts, equal:
  /// Σ n_a of the first = Σ n_a of the second.
  void AddEquations(QuantisationProblem& problem) const;

private:
  struct Part
  {
    std::vector<int> first;
    std::vector<int> second;
    std::string pair; ///< Its name in messages.
  };

  std::vector<Part> Parts;
};
}
