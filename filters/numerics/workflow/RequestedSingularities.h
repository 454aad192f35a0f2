#pragma once

#include "ResolvedRequest.h"
#include "SizedConfigurations.h"

namespace crossfield
{
/// Returns the given singularities of a request with pairs for its target sizes (AddPairsForSizes).
std::optional<SizedConfiguration> WithPairs(
  const PlanarDomain& domain, const ResolvedRequest& request, const Progress& progress = {});

/// Returns a sentence with what pairs for the target sizes of a request would give, and what other
/// singularities would; empty if both are no better than the given ones.
std::string DescribeOthersForSizes(const PlanarDomain& domain, const ResolvedRequest& request);

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
