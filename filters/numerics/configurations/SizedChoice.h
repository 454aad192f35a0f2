#pragma once

#include "ChosenConfiguration.h"
#include "SizedConfigurations.h"

namespace crossfield
{
/// Chooses singularities for target sizes (SizedConfigurations.h). Further ones, with other numbers of
/// nodes, are AutomaticConfiguration::others. Returns nothing if the search has none.
std::optional<AutomaticConfiguration> ChooseForSizes(
  const PlanarDomain& domain, const AutomaticOptions& options, const Progress& progress);

/// Returns the spread (SizedConfiguration) of the given singularities of the options.
double SpreadOfGiven(const PlanarDomain& domain, const AutomaticOptions& options);

/// Adds pairs of quarter indices 1 and −1 to the given singularities of the options for target sizes, at
/// most OptimizerOptions::pairs. Returns nothing if there is no such configuration.
std::optional<SizedConfiguration> AddPairsForSizes(
  const PlanarDomain& domain, const AutomaticOptions& options, const Progress& progress = {});
}
