#pragma once

#include "ConstrainedMinimiser.h"
#include "GinzburgLandauEnergy.h"

namespace crossfield
{
/// A local minimiser of the Ginzburg-Landau energy under quadratic constraints on some edges
/// (METHOD §3, variant 6; paper: "add to our method the non-linear penalty").
///
/// By ConstrainedMinimiser.h with M = D + K, the metric of the penalty and the stiffness matrix, and
/// one sparse factorisation for each step. The unknowns of `constraints` are positions in
/// energy.FreeEdges(); `start` has one value per edge of the mesh, and so has the result.
MinimiserResult SolvePenalised(const GinzburgLandauEnergy& energy,
  const std::vector<QuadraticConstraint>& constraints, const ComplexVector& start,
  const MinimiserOptions& options = {}, const Progress& progress = {});
}
