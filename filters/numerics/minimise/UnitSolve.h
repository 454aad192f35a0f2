#pragma once

#include "Minimisation.h"
#include "Progress.h"
#include "ReducedProblem.h"

namespace crossfield
{
/// The best found minimiser of ½ xᴴ S x − Re(bᴴ x) over unit values that turn evenly, x_j = e^{i(d α_j + φ_i)} on
/// hole i, with α_j the angle of edge j seen from its centre and one free phase φ_i per hole.
///
/// That is what |x_j| = 1 on every edge together with the degree constraint says (docs/method.md §3.6;
/// paper: "we may have to force the crosses on some holes to have a norm equal to 1"): of all unit
/// values of degree d that never turn back, those that turn evenly alone reach C = t. So the degree is
/// right by construction, where without the norm the minimiser may reach C = t with a wrong one.
///
/// Newton's method on the phases with a line search, started at those nearest to `start`, for
/// example the values of the unit-norm field; negative curvatures of the Hessian count by their
/// size. Then it is started again with the phase of each hole in turn turned by π from the best so far,
/// until no hole gives anything better. That nothing is lower is not proved, but in tests with few holes
/// looking everywhere found nothing (docs/method.md §3.6).
///
/// Iterations and residual are those of the descent that won. Multipliers are not computed and 0. S
/// must be that of a potential with periods around holes (PotentialReduction.h).
MinimiserResult SolveReducedUnit(const ReducedProblem& problem, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});

/// The values of every hole turned by a phase of its own, by the same descent from where they are: less of ½ xᴴ S x −
/// Re(bᴴ x), and every degree as it was.
ComplexVector RelaxPhases(const ReducedProblem& problem, const ComplexVector& x);
}
