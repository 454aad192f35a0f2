#pragma once

#include "MeshBoundary.h"
#include "PairedSides.h"
#include "QuantisationProblem.h"
#include "TMesh.h"

#include "SeamlessMap.h"

namespace crossfield
{
/// Adds nodes to a T-mesh at the ends of paired sides, at the corners on them, and at the images of these
/// corners on the other side, so that quads have nodes there.
void SplitAtPairs(const SeamlessMap& map, const MeshBoundary& curves, const BoundarySides& sides,
  const std::vector<PairedSides>& pairs, TMesh& mesh);

/// Returns the sums of edge counts that make both sides of each pair, and their parts between these
/// nodes, equal, for a T-mesh that is split there: Σ n_a of the first − Σ n_a of the second = 0.
std::vector<CountSum> PairSums(const SeamlessMap& map, const MeshBoundary& curves,
  const BoundarySides& sides, const std::vector<PairedSides>& pairs, const TMesh& mesh);
}
