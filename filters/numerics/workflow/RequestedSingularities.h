#pragma once

#include "ResolvedRequest.h"

namespace crossfield
{
/// Chooses the singularities, and the corners that go with them, for the quads of a request; the
/// request's own singularities are ignored. Throws Error as ChooseConfiguration does.
AutomaticConfiguration ChooseSingularities(
  const PlanarDomain& domain, const ResolvedRequest& request, const Progress& progress = {});

/// Moves all of the given singularities towards a minimum of the renormalised energy, with the clearance
/// for the quads of a request; `converged` says whether they reach it. Throws Error as
/// OptimizeSingularities does.
OptimizerResult MinimiseEnergy(const PlanarDomain& domain, const ResolvedRequest& request,
  const Configuration& given, const Progress& progress = {});

/// Repairs the holonomy with the corners that the map will have (HolonomyRepair.h).
HolonomyRepair RepairForMap(const PlanarDomain& domain, const Configuration& singularities,
  const SeamlessMapOptions& options, double meshSize, const Progress& progress = {});
}
