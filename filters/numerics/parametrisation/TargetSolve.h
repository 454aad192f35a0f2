#pragma once

#include "MapTargets.h"
#include "Progress.h"

namespace crossfield
{
/// Solves the seamless problem of targets (docs/method.md §12.2, §12.3): cuts the mesh open, makes
/// the branches continuous except across the cut, eliminates the equations of seams and sides, turns
/// the map of a closed surface (BestAngle.h), and scales it to the area of the domain. Sets all members of the
/// map but the holonomy defects. Does not check that the map is injective.
///
/// Throws Error when the jumps have a singularity that is not among the cones, and when the mesh is
/// too coarse to be cut.
SeamlessMap SolveTargets(
  MapTargets targets, const std::vector<Cone>& cones, const Progress& progress = {});
}
