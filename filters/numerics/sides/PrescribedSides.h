#pragma once

#include "BoundarySides.h"
#include "MeshBoundary.h"
#include "QuantisationProblem.h"
#include "SidePrescription.h"
#include "TMesh.h"

#include "SeamlessMap.h"

namespace crossfield
{
/// Returns the sums of edge counts that are prescribed, for a T-mesh that is split at the ends of
/// the sides (SplitAtSides). Throws Error if edges are too long for a part of their side.
std::vector<CountSum> PrescribedSums(const SeamlessMap& map, const MeshBoundary& curves,
  const BoundarySides& sides, const SidePrescriptions& prescribed, const TMesh& mesh);
}
