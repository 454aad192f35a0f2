#pragma once

#include "CrossFieldReport.h"
#include "ReducedProblem.h"

namespace crossfield
{
/// How the field on a perforated domain is computed.
enum class PerforatedMethod
{
  Constrained, ///< ConstrainedField.h: |u| free, one quadratic degree constraint per hole.
  UnitNorm     ///< UnitNormField.h: |u| = 1, from one linear system.
};

struct PerforatedOptions
{
  PerforatedMethod method = PerforatedMethod::Constrained;
  ReducedOptions reduced; ///< Of the constrained method.
};

/// The smoothest cross field on a drilled mesh with the degrees prescribed on its holes, and a
/// report on what came out.
///
/// Throws Error when the quarter indices violate Poincaré-Hopf or a hole has too few edges for its
/// degree. An iteration that does not converge is not an error: see CrossField::converged.
CrossField SolvePerforated(const TriangleMesh& mesh, const PerforatedOptions& options = {},
  const Progress& progress = {});
}
