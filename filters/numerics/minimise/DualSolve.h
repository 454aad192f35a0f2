#pragma once

#include "HoleBases.h"
#include "Minimisation.h"
#include "Progress.h"

namespace crossfield
{
/// Solves the reduced problem by Newton's method on the dual (DualMaximum.h), which keeps S + Σ λ_i
/// A_i positive definite. A converged solution is therefore the global minimiser of the problem,
/// not only a critical point. The first steps use only the low Fourier modes of the holes, which
/// carry most of the field. Where the dual has its maximum on the border of the region in which
/// that matrix is positive definite, no solution of this kind exists; this is reported by
/// `converged` and is not an error. The bases of a problem may be used for several solves.
MinimiserResult SolveReduced(
  const HoleBases& bases, const MinimiserOptions& options = {}, const Progress& progress = {});
}
