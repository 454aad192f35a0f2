#pragma once

#include "Progress.h"
#include "ProposedConfiguration.h"

namespace crossfield
{
/// The configurations that ProposeConfigurations tries, consistent and not yet judged: those of the
/// options first, then the variations.
std::vector<ProposedConfiguration> FindStarts(
  const PlanarDomain& domain, const ProposalOptions& options, const Progress& progress = {});
}
