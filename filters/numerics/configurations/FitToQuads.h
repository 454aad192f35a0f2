#pragma once

#include "ChosenConfiguration.h"

namespace crossfield
{
/// Returns the requested clearance of singularities, or that for quads, 0 if none are made.
double RequestedClearance(const PlanarDomain& domain, const AutomaticOptions& options);

/// Continues the optimisation from the minimum of the energy with the clearance for quads, towards
/// the target sizes if there are any, or towards uniform sizes if the sizes are far from uniform
/// and `movesForSizes`. Returns whether it was for the latter.
bool FitToQuads(const PlanarDomain& domain, const AutomaticOptions& options, double quadsAtHoles,
  bool movesForSizes, const Progress& progress, AutomaticConfiguration& result);

/// Sets the others of the best configuration, fitted to quads: `minimum`, which is the best one before
/// it was fitted, in other ways, and starts with other numbers of singularities. `isUneven`: the result
/// of FitToQuads for the best one.
void FitOthers(const PlanarDomain& domain, const AutomaticOptions& options,
  const std::vector<ProposedConfiguration>& starts, const AutomaticConfiguration& minimum,
  bool isUneven, const Progress& progress, AutomaticConfiguration& best);
}
