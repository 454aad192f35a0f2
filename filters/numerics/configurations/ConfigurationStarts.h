#pragma once

#include "Progress.h"
#include "ProposedConfiguration.h"

namespace crossfield
{
/// Returns the configurations that ProposeConfigurations evaluates: consistent, not yet ranked,
/// those with the corners of the options first, then variations.
std::vector<ProposedConfiguration> FindStarts(
  const PlanarDomain& domain, const ProposalOptions& options, const Progress& progress = {});
}
