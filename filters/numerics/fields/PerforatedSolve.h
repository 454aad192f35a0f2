#pragma once

#include "Alignment.h"
#include "PerforatedOptions.h"
#include "Progress.h"
#include "SolvedField.h"

namespace crossfield
{
/// The smoothest cross field on a drilled mesh with the degrees prescribed on its holes, and a
/// report on what came out.
///
/// Meshes with imprinted circles and the options for the variants go to VariantSolve.h.
///
/// Throws Error when the quarter indices violate Poincaré-Hopf or a hole has too few edges for its
/// degree. An iteration that does not converge is not an error: see SolveReport::converged.
SolvedField SolvePerforated(const SharedTopology& topology, const PerforatedOptions& options = {},
  const Progress& progress = {});

/// The same on a mesh that is factored already, but for the variants: any number of methods and corners
/// for one factorisation.
SolvedField SolvePerforated(const std::shared_ptr<const PotentialSolver>& potential,
  const PerforatedOptions& options = {}, const Progress& progress = {});
}
