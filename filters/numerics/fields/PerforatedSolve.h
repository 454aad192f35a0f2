#pragma once

#include "Alignment.h"
#include "PerforatedOptions.h"
#include "Progress.h"
#include "SolvedField.h"

namespace crossfield
{
/// Returns the smoothest cross field on a drilled mesh with the degrees prescribed on its holes,
/// and a report on the result.
///
/// Meshes with imprinted circles and the options for the variants are handled by VariantSolve.h.
///
/// Throws Error when the quarter indices violate Poincaré-Hopf or a hole has too few edges for its
/// degree. An iteration that does not converge is not an error: see SolveReport::converged.
SolvedField SolvePerforated(const SharedPlanarTopology& topology,
  const PerforatedOptions& options = {}, const Progress& progress = {});

/// Solves on a mesh that has already been factored, so that any number of methods and corners share
/// one factorisation. The variants are not supported.
SolvedField SolvePerforated(const std::shared_ptr<const PotentialSolver>& potential,
  const PerforatedOptions& options = {}, const Progress& progress = {});
}
