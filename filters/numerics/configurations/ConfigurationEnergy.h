#pragma once

#include "FactoredDomain.h"
#include "PerforatedEnergy.h"
#include "Progress.h"
#include "RenormalizedEnergy.h"

#include <optional>

namespace crossfield
{
/// Energies of one of several configurations on a domain.
struct ConfigurationEnergy
{
  int configuration = 0;   ///< Index in the given list.
  bool consistent = false; ///< If false, only the reason is set.
  std::string reason;      ///< Result of the Poincaré-Hopf count.
  /// E_ρ with a hole at every singularity, on the mesh of EnergyMesh.h.
  std::optional<PerforatedEnergy> perforated;
  RenormalizedEnergyValue renormalized;
  double coreRadius = 0.0;   ///< Core radius of the options, resolved (ResolveCoreRadius).
  double atCoreRadius = 0.0; ///< Energy at the core radius.
  /// Interior singularities in the order given; the columns of the gradient.
  Configuration interior;
};

struct ConfigurationEnergyOptions
{
  double meshSize = 0.0; ///< As in DrillOptions.
  std::vector<CornerChoice> corners;
  double coreRadius = 0.0; ///< As in ResolveCoreRadius.
};

/// Returns the core radius at which energies are reported, a length. 0 stands for 1/100 of the
/// diagonal: the error o(1) of the energy is small there.
double ResolveCoreRadius(double coreRadius, const PlanarDomain& domain);

/// Computes the energies of configurations on a domain, sorted by the energy at the core radius ρ,
/// W + coefficient × log(1/ρ) + CoreOverlapEnergy (docs/method.md §5.6), lowest first; inconsistent configurations come
/// last. Singularities may be located on the boundary (ConfigurationPlacement.h). E_ρ needs a mesh
/// for each configuration; W needs one mesh without holes for all of them (MeshForConfigurations),
/// which is factored once.
///
/// Throws Error if a singularity lies outside, or its hole intersects the boundary or another hole.
std::vector<ConfigurationEnergy> CompareConfigurations(const PlanarDomain& domain,
  const std::vector<Configuration>& configurations, const ConfigurationEnergyOptions& options = {},
  const Progress& progress = {});

/// Computes W alone on a factored domain, for interactive moves of singularities. Nothing is meshed
/// or factored, except, once for the domain, the second factor that W needs. Singularities on the
/// boundary must be vertices of the mesh; the mesh size of the options is ignored.
///
/// Throws Error if a singularity lies outside.
std::vector<ConfigurationEnergy> CompareRenormalizedEnergies(const FactoredDomain& domain,
  const std::vector<Configuration>& configurations, const ConfigurationEnergyOptions& options = {},
  const Progress& progress = {});
}
