#pragma once

#include "OptimizerResult.h"
#include "Progress.h"

namespace crossfield
{
/// Moves the interior singularities downhill on the renormalised energy W (RenormalizedEnergy.h;
/// docs/method.md §5.5; paper, "The unifying renormalized Ginzburg-Landau energy"). With inner loops the
/// holonomy defects are equality constraints, the nearest multiple of 2π apart: the result has an
/// aligned field of norm one with single-valued H, unless no singularity can change a defect.
///
/// One mesh is factored, and another one when a singularity comes nearer to the boundary than its
/// edges are long. A barrier keeps singularities at the clearance; one that is held there does not stop
/// the others. Unless all are to be kept:
/// - one that is pressed against the boundary becomes one of the boundary, at a corner or vertex next to
///   it, and one on the boundary moves inside, where that lowers the energy E_ρ at ρ = 1/400 of the diagonal;
/// - two of opposite sign that meet are taken out, or become one of their sum.
/// A start nearer to the boundary than the clearance is moved off it.
///
/// Given radii that do not fit any more are shrunk. An abort after the first evaluation keeps the best.
/// Throws Error when the quarter indices violate Poincaré-Hopf, a singularity lies outside, or the
/// clearance is negative.
OptimizerResult OptimizeSingularities(const PlanarDomain& domain, const Configuration& start,
  const OptimizerOptions& options = {}, const Progress& progress = {});
}
