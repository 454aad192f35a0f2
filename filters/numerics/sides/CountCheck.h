#pragma once

#include "BoundarySides.h"
#include "QuadMesh.h"
#include "SidePrescription.h"

namespace crossfield
{
/// Throws Error if prescribed numbers of edges contradict those of the other sides so much that the quads, which are not
/// smoothed yet, cannot be untangled: some are inverted, and the edges of a side are 16 times shorter or longer than quads of
/// the mean size. Smoothing would take tens of thousands of steps, and the quads would stay inverted or nearly so.
void RequireSuitableCounts(const QuadMesh& mesh, double area, const BoundarySides& sides,
  const SidePrescriptions& prescribed);
}
