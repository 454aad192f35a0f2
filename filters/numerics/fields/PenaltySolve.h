#pragma once

#include "ConstrainedMinimiser.h"
#include "GinzburgLandauEnergy.h"

namespace crossfield
{
/// A local minimiser of the Ginzburg-Landau energy (docs/method.md §4.1), under quadratic constraints
/// on some edges (docs/method.md §3.7, variant 6; paper: "add to our method the non-linear penalty") or none.
///
/// By ConstrainedMinimiser.h with one sparse factorisation for each step. M is D, the metric of the
/// penalty, which makes up for all of its negative curvature, and on the constrained edges the mean
/// diagonal of the stiffness matrix besides, some multiple of which makes up for that of Σ λ_i A_i. The
/// unknowns of `constraints` are positions in energy.FreeEdges(); `start` has one value per edge of the
/// mesh, and so has the result.
MinimiserResult SolveWithPenalty(const GinzburgLandauEnergy& energy,
  const std::vector<QuadraticConstraint>& constraints, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});
}
