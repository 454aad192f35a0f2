#pragma once

#include "ChosenConfiguration.h"

namespace crossfield
{
/// If singularities have more symmetries of the domain after moves of at most `distance`, continues
/// from there, within the solves that `options` leave, and uses the result if it has more
/// symmetries and its energy is higher by less than these are worth.
void ImposeSymmetry(const PlanarDomain& domain, const OptimizerOptions& options, double distance,
  const Progress& progress, AutomaticConfiguration& result);
}
