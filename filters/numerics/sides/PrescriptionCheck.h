#pragma once

#include "BoundarySides.h"
#include "SidePrescription.h"

namespace crossfield
{
/// Throws Error if prescriptions are out of range, contradict each other on one side, or prescribe a
/// progression on a closed curve, which has no ends.
void RequireConsistent(const BoundarySides& sides, const std::vector<LoopArc>& loops,
  const SidePrescriptions& prescribed);
}
