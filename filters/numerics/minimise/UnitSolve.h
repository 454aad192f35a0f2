#pragma once

#include "Minimisation.h"
#include "Progress.h"
#include "ReducedProblem.h"

namespace crossfield
{
/// Returns the best minimiser found of ½ xᴴ S x − Re(bᴴ x) over evenly turning unit values, x_j =
/// e^{i(d α_j + φ_i)} on hole i, where α_j is the angle of edge j seen from the centre of the hole
/// and φ_i is one free phase per hole.
///
/// This is equivalent to |x_j| = 1 on every edge together with the degree constraint
/// (docs/method.md §3.6; paper: "we may have to force the crosses on some holes to have a norm
/// equal to 1"): among all unit values of degree d that never turn back, only the evenly turning
/// ones satisfy C = t. So the degree is correct by construction, whereas without the norm the
/// minimiser may reach C = t with a wrong degree.
///
/// Uses Newton's method on the phases with a line search, started at those nearest to `start`, for
/// example the values of the unit-norm field. Negative curvatures of the Hessian are replaced by
/// their absolute values. The descent is then restarted from the best result with the phase of each
/// hole in turn turned by π, until no hole gives an improvement. Global optimality is not proved,
/// but in tests with few holes an exhaustive search found nothing lower (docs/method.md §3.6).
///
/// Iterations and residual are those of the best descent. Multipliers are not computed and are 0. S
/// must belong to a potential with periods around holes (PotentialReduction.h).
MinimiserResult SolveReducedUnit(const ReducedProblem& problem, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});

/// Rotates the values of every hole by a phase of its own, by the same descent from their current
/// phases. Decreases ½ xᴴ S x − Re(bᴴ x) and leaves every degree unchanged.
ComplexVector RelaxPhases(const ReducedProblem& problem, const ComplexVector& x);
}
