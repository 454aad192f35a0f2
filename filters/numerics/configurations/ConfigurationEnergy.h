#pragma once

#include "FactoredDomain.h"
#include "PerforatedEnergy.h"
#include "Progress.h"
#include "RenormalizedEnergy.h"

#include <optional>

namespace crossfield
{
/// What one of several configurations on a domain costs.
struct ConfigurationEnergy
{
  int configuration = 0;   ///< Number in the list that was given.
  bool consistent = false; ///< Otherwise nothing else but the reason is set.
  std::string reason;      ///< Result of the Poincaré-Hopf count.
  /// E_ρ, with a hole at every singularity, on the mesh of EnergyMesh.h.
  std::optional<PerforatedEnergy> perforated;
  RenormalizedEnergyValue renormalized;
  double coreRadius = 0.0;   ///< As in the options, resolved,
  double atCoreRadius = 0.0; ///< and the energy at it.
  Configuration interior;    ///< The columns of the gradient, in the order given.
};

struct ConfigurationEnergyOptions
{
  double meshSize = 0.0; ///< As in DrillOptions.
  std::vector<CornerChoice> corners;
  double coreRadius = 0.0; ///< As in ResolveCoreRadius.
};

/// The core radius at which configurations of different Σ k² are compared, a length; 0: 1/100 of the
/// diagonal, where the error o(1) of the energy is small and cores cost what they do in a quad mesh.
double ResolveCoreRadius(double coreRadius, const PlanarDomain& domain);

/// Energies of configurations on a domain, the best first: the least at the core radius ρ,
/// W + coefficient × log(1/ρ) (docs/method.md §5.6); inconsistent ones come last. Singularities may lie on the boundary (ConfigurationPlacement.h). E_ρ takes a mesh for every
/// configuration; W takes one without holes for all of them (MeshForAll), factored once.
///
/// Throws Error when a singularity lies outside, or its hole cuts the boundary or another hole.
std::vector<ConfigurationEnergy> CompareConfigurations(const PlanarDomain& domain,
  const std::vector<Configuration>& configurations, const ConfigurationEnergyOptions& options = {},
  const Progress& progress = {});

/// The same of W alone on a domain that is factored, for a hand that moves singularities: nothing is meshed or factored but, once for
/// the domain, the second factor that W takes. Singularities on the boundary are vertices of it; the mesh size of the options means nothing.
///
/// Throws Error when a singularity lies outside.
std::vector<ConfigurationEnergy> CompareRenormalizedEnergies(const FactoredDomain& domain,
  const std::vector<Configuration>& configurations, const ConfigurationEnergyOptions& options = {},
  const Progress& progress = {});
}
