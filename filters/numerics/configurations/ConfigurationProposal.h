#pragma once

#include "BoundarySymmetry.h"
#include "Progress.h"
#include "ProposedConfiguration.h"

namespace crossfield
{
/// Proposes consistent starting configurations, the best first (docs/method.md §5.6). The sources
/// are the search (GlobalSearch.h) and, where it finds none or alternatives are requested, a coarse Ginzburg-Landau field (FieldConfiguration.h), the same field without pairs of
/// opposite signs, and a spread configuration (ConfigurationSpread.h). Each is improved by a few
/// steps of the optimiser, and the first is that of the lowest OptimizerResult::objective. Configurations
/// with too few singularities for the inner loops (TooFewForHolonomy) are also proposed with
/// additional pairs. Configurations with a remaining defect and variations are never ranked first.
/// All but the first are sorted by their energy at the core radius. Equal configurations are returned once. Variations
/// whose cores overlap have no energy at the core radius and are not returned.
///
/// If the domain has symmetries (CurveSymmetry.h), positions that are approximately symmetric
/// are symmetrised up to rounding.
///
/// With given singularities, or with `cancelFlatCorners`, which proposes the spread configuration
/// only, nothing is moved. The singularities of the field closest to given ones are replaced by
/// these. Throws Error if a given singularity lies outside the domain, if there is not enough
/// space, or as OptimizeSingularities does.
std::vector<ProposedConfiguration> ProposeConfigurations(
  const PlanarDomain& domain, const ProposalOptions& options = {}, const Progress& progress = {});

/// Moves singularities to positions that are symmetric, if these are within a distance for some symmetries
/// of the domain. Returns false and moves nothing if there are none, or if a singularity would leave the
/// domain, as on the axis of a narrow neck, or the boundary, where only the curves are symmetric.
bool MakeSymmetric(const PlanarDomain& domain, const SymmetryGroup& symmetries, double distance,
  Configuration& singularities);

/// Returns Σ π k² over singularities + 16 Σ e(α, k) over corners (CornerEnergy.h), the coefficient
/// of log(1/ρ) in the energy of an aligned field (docs/method.md §5.3, §6.4).
double LogarithmCoefficient(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& corners = {}, double cornerAngle = DefaultCornerAngle);
}
