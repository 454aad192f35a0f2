#pragma once

#include "ReducedProblem.h"

namespace crossfield
{
/// A local minimiser of the reduced problem near a given point, for example near the values of the
/// unit-norm field; its degrees can be right where those of the global minimiser are not.
///
/// Sequential quadratic programming with a line search on the merit ½ xᴴ S x − Re(bᴴ x) + ν Σ |c_i|,
/// c_i = C_i(x) − t_i. Where the Lagrangian's Hessian is not positive definite on the constraints'
/// tangent space it is convexified by a multiple of S. The solution is converged only if no such
/// help is needed there, that is, if the optimality system has as many negative eigenvalues as
/// constraints; otherwise it is a saddle.
ReducedSolution SolveReducedFrom(const ReducedProblem& problem, const ComplexVector& start,
  const ReducedOptions& options = {}, const Progress& progress = {});
}
