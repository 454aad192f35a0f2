#pragma once

#include "CrossFieldReport.h"
#include "ReducedProblem.h"

namespace crossfield
{
/// The constrained problem of ConstrainedField.h in its direct form (docs/method.md §3): the oracle that the
/// reduced form is compared with.
///
/// The Crouzeix-Raviart stiffness matrix itself is factored with the hole edges last; its trailing
/// block is the Schur complement S on them, and the energy is ½ uᴴ K u.
CrossField SolvePerforatedDirectly(const TriangleMesh& mesh, const ReducedOptions& options = {});
}
