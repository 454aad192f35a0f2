#pragma once

#include "Progress.h"
#include "ProposedConfiguration.h"

namespace crossfield
{
/// Consistent starting configurations, the best first (docs/method.md §5.6): what a coarse Ginzburg-Landau
/// field shows (FieldConfiguration.h), the same without pairs of opposite signs, and one that is spread
/// (ConfigurationSpread.h); each after a few steps of the optimiser, and sorted by the energy at the core
/// radius. Those with too few singularities for the inner loops (TooFewForHolonomy) come with pairs as
/// well, and are not the first if a defect stays, nor are variations. All but the first are sorted by the
/// energy alone. Equal ones are given once, and variations whose cores overlap, which have no energy at that radius, not at all.
///
/// Where a domain has symmetries (BoundarySymmetry.h), places that are about symmetric are so to rounding.
///
/// With given singularities, or `cancelFlatCorners`, for which the one that is spread is the only one,
/// nothing is moved. What the field shows nearest to given ones is theirs. Throws Error when a given
/// singularity lies outside the domain, where there is no room, or as OptimizeSingularities does.
std::vector<ProposedConfiguration> ProposeConfigurations(
  const PlanarDomain& domain, const ProposalOptions& options = {}, const Progress& progress = {});

/// Σ π k² over singularities + 16 Σ e(α, k) over corners (CornerEnergy.h): what log(1/ρ) is multiplied
/// with in the energy of an aligned field (docs/method.md §5.3, §6.4).
double LogarithmCoefficient(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& corners = {}, double cornerAngle = DefaultCornerAngle);
}
