#pragma once

#include "PerforatedOptions.h"
#include "Progress.h"
#include "SolvedField.h"

namespace crossfield
{
/// Whether a solve is one of the variants: the mesh has imprinted circles, or the options ask for the
/// global constraint, unit norm on chosen holes, or the penalty.
bool IsVariant(const MeshTopology& topology, const PerforatedOptions& options);

/// The variants of the constrained solve (docs/method.md §3.7, 2 to 6; paper, "Analysis of the numerical
/// results"), in any combination but that of the penalty with unit norms. "Hole" stands for
/// imprinted circles as well.
///
/// 1. Everything but the edges of the holes is eliminated (DirectReduction.h), and the quadratic
///    problem on them is solved: by the dual method of ReducedProblem.h from the harmonic field, or
///    by ConstrainedMinimiser.h from unit crosses that turn evenly on every hole, each with the
///    phase nearest to the unit-norm field, or, where that does not exist, to the harmonic field.
///    Those satisfy every constraint, have all degrees, and exist for every sum of quarter indices;
///    PerforatedStart::UnitNorm stands for them here. With the global constraint or unit norms only
///    the second way is there, from either start.
/// 2. With the penalty, PenaltySolve.h goes on from there; from PerforatedStart::UnitNorm it starts
///    at the unit-norm field itself, where that exists.
///
/// A hole with unit norm has x_j = e^{i (d α_j + φ)} with one free phase φ, as in UnitSolve.h.
///
/// Throws Error as SolvePerforated does; an inconsistent sum is an error only where the domain is
/// perforated and there is no penalty.
SolvedField SolveVariant(const SharedTopology& topology, const PerforatedOptions& options = {},
  const Progress& progress = {});
}
