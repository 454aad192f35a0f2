#pragma once

#include "CrossFieldReport.h"
#include "PerforatedOptions.h"
#include "Progress.h"

namespace crossfield
{
/// The smoothest cross field on a drilled mesh with the degrees prescribed on its holes, and a
/// report on what came out.
///
/// Meshes with imprinted circles and the options for the variants go to VariantSolve.h.
///
/// Throws Error when the quarter indices violate Poincaré-Hopf or a hole has too few edges for its
/// degree. An iteration that does not converge is not an error: see CrossField::converged.
CrossField SolvePerforated(
  const TriangleMesh& mesh, const PerforatedOptions& options = {}, const Progress& progress = {});
}
