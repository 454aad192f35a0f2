#pragma once

#include "CrossFieldReport.h"
#include "ReducedProblem.h"

namespace crossfield
{
/// Minimises ½ uᴴ K u over Crouzeix-Raviart fields with u = e^{4iτ} on every outer and inner
/// boundary edge and C_i(u) = t_i on every hole (METHOD §3; paper, "Singularity placements via
/// perforation strategy").
///
/// K is factored once with the hole unknowns last; its trailing block is the Schur complement S on
/// them, and with x⁰ the harmonic values (no constraint) there, what remains is
///   minimise ½ (x − x⁰)ᴴ S (x − x⁰)   subject to   ½ xᴴ A_i x = t_i,
/// solved by Newton's method on the dual (ReducedProblem.h), started at x⁰. Difference from the paper:
/// the Hessian is S + Σ λ_i A_i (printed there without λ_i).
///
/// Throws Error when the quarter indices violate Poincaré-Hopf or a hole has too few edges for its
/// degree. A Newton iteration that does not converge is not an error: see CrossField::converged.
CrossField SolvePerforated(const TriangleMesh& mesh, const ReducedOptions& options = {},
  const Progress& progress = {});
}
