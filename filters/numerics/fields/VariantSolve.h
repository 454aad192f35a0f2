#pragma once

#include "PerforatedOptions.h"
#include "Progress.h"
#include "SolvedField.h"

namespace crossfield
{
/// Returns whether a solve is one of the variants: the mesh has imprinted circles, or the options
/// request the global constraint, unit norm on chosen holes, or the penalty.
bool IsVariant(const PlanarTopology& topology, const PerforatedOptions& options);

/// Computes the variants of the constrained solve (docs/method.md §3.7, 2 to 6; paper, "Analysis of
/// the numerical results"), in any combination except the penalty with unit norms. Here "hole"
/// includes imprinted circles.
///
/// 1. All unknowns except the edges of the holes are eliminated (DirectReduction.h), and the
/// quadratic problem on these edges is solved. This uses either the dual method of DualSolve.h from
/// the harmonic field, or ConstrainedMinimiser.h from unit crosses that turn evenly on every hole,
/// each with the phase nearest to the unit-norm field or, where that does not exist, to the
/// harmonic field. These crosses satisfy every constraint, have all degrees, and exist for every
/// sum of quarter indices; PerforatedStart::UnitNorm selects them here. With the global constraint
/// or unit norms only the second method is available, from either start.
/// 2. With the penalty, PenaltySolve.h continues from there; with PerforatedStart::UnitNorm it
/// starts from the unit-norm field itself, where that exists.
///
/// A hole with unit norm has x_j = e^{i (d α_j + φ)} with one free phase φ, as in UnitSolve.h.
///
/// Throws Error as SolvePerforated does; an inconsistent sum is an error only where the domain is
/// perforated and there is no penalty.
SolvedField SolveVariant(const SharedPlanarTopology& topology,
  const PerforatedOptions& options = {}, const Progress& progress = {});
}
