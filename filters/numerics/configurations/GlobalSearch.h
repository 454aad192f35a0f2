#pragma once

#include "Progress.h"
#include "ProposedConfiguration.h"

namespace crossfield
{
/// Configuration of the search, before its positions are optimised.
struct SearchedConfiguration
{
  Configuration singularities;
  std::size_t symmetries = 1;
  /// Energy at 1/400 of the diagonal up to a constant, less the worth of the symmetries.
  double objective = 0.0;
};

/// Returns the distance of candidate sites from the boundary: a hundredth of the diagonal, or a
/// quarter of the median gap around inner loops, if that is less.
double SiteClearance(const PlanarDomain& domain);

/// Searches all configurations at candidate sites (docs/method.md §5.10): W is a quadratic form in
/// the quarter indices there, so that every exchange of two singularities costs one addition. Returns
/// different minima, the best first. Returns none where the sites do not suffice: if none is far
/// enough from the boundary, if inner loops are closer to each other than the sites, or if the
/// boundary has rounded corners within quads of ProposalOptions::quadSize, which take singularities.
std::vector<SearchedConfiguration> SearchConfigurations(
  const PlanarDomain& domain, const ProposalOptions& options = {}, const Progress& progress = {});
}
