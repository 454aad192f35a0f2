#pragma once

#include "ChosenConfiguration.h"

namespace crossfield
{
/// Gives quarter index 1 to sharp corners of index 2 (PoincareHopf.h). If there are any, sets
/// keepAll: a singularity that moved into such a corner would undo the change.
void CapCorners(const PlanarDomain& domain, AutomaticOptions& options);

/// Chooses the singularities of a domain: proposes starts (ConfigurationProposal.h) and moves their
/// interior singularities to a minimum of the renormalised energy (SingularityOptimizer.h), from
/// one start after the other until a run converges without a holonomy defect. After that, only starts
/// are tried whose objective is below that of the result.
/// If no run converges, the one with the smallest defect is used, and among those without a defect
/// the one with the lowest energy; this is no error: optimum.converged is false, and the last event
/// gives the reason.
///
/// For quads a second run follows, with the clearance for quads. It also moves to the target sizes
/// if their sizing is Uniform or Field, and to uniform sizes if the sizes at the minimum are far
/// from uniform (docs/method.md §5.7).
///
/// Throws Error as ProposeConfigurations and OptimizeSingularities do.
AutomaticConfiguration ChooseConfiguration(
  const PlanarDomain& domain, const AutomaticOptions& options = {}, const Progress& progress = {});
}
