#pragma once

#include "HoleBases.h"
#include "Minimisation.h"
#include "Progress.h"

namespace crossfield
{
/// Newton's method on the dual (DualMaximum.h), which keeps S + Σ λ_i A_i positive definite, so a
/// converged solution is the global minimiser of the problem, not only a critical point. The first
/// steps are taken in the low Fourier modes of the holes only, which carry most of the field. Where the
/// dual has its maximum on the border of the region in which that matrix is positive definite, no
/// solution of this kind exists: reported by `converged`, not an error. The bases of a problem may serve several solves.
MinimiserResult SolveReduced(
  const HoleBases& bases, const MinimiserOptions& options = {}, const Progress& progress = {});
}
