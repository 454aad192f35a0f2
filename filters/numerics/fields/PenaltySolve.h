#pragma once

#include "ConstrainedMinimiser.h"
#include "GinzburgLandauEnergy.h"

namespace crossfield
{
/// Finds a local minimiser of the Ginzburg-Landau energy (docs/method.md §4.1), with or without
/// quadratic constraints on some edges (docs/method.md §3.7, variant 6; paper: "add to our method
/// the non-linear penalty").
///
/// Uses ConstrainedMinimiser.h with one sparse factorisation per step. M is D, the metric of the
/// penalty, which compensates all of its negative curvature, plus the mean diagonal of the
/// stiffness matrix on the constrained edges, some multiple of which compensates that of Σ λ_i A_i.
/// The unknowns of `constraints` are positions in energy.FreeEdges(). `start` and the result have
/// one value per edge of the mesh.
MinimiserResult SolveWithPenalty(const GinzburgLandauEnergy& energy,
  const std::vector<QuadraticConstraint>& constraints, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});
}
