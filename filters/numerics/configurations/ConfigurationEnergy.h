#pragma once

#include "PerforatedEnergy.h"
#include "Progress.h"
#include "RenormalizedEnergy.h"

namespace crossfield
{
/// What one of several configurations on a domain costs.
struct ConfigurationEnergy
{
  int configuration = 0;       ///< Number in the list that was given.
  bool consistent = false;     ///< Otherwise nothing else but the reason is set.
  std::string reason;          ///< Verdict of the Poincaré-Hopf theorem.
  PerforatedEnergy perforated; ///< E_ρ, with a hole at every singularity.
  RenormalizedEnergyValue renormalized;
  Configuration interior; ///< The columns of the gradient, in the order given.

  /// Of the energy of a field that may rotate along the boundary: the middle of its bounds, whose
  /// errors have opposite signs.
  double DegreeOnly() const
  {
    return 0.5 * (this->perforated.degreeOnlyLower + this->perforated.degreeOnlyUpper);
  }
};

struct ConfigurationEnergyOptions
{
  double meshSize = 0.0; ///< As in DrillOptions.
  std::vector<CornerChoice> corners;
};

/// Energies of configurations on a domain, the best first: the least coefficient of the logarithm, equal
/// within 1e-5 of it, then the least W, which is the order of E_ρ for small ρ; inconsistent ones come
/// last. Singularities may lie on the boundary (ConfigurationPlacement.h). E_ρ takes a mesh for every
/// configuration; W takes one without holes for all of them, factored once.
///
/// Throws Error when a singularity lies outside, or its hole cuts the boundary or another hole.
std::vector<ConfigurationEnergy> CompareConfigurations(const PlanarDomain& domain,
  const std::vector<Configuration>& configurations, const ConfigurationEnergyOptions& options = {},
  const Progress& progress = {});
}
