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
/// the quarter indices there, so that every exchange of two singularities costs one addition. The
/// options give the corners, and the size of quads that decides which indices the boundary may have
/// (BoundaryVertices::Allows). Singularities on the boundary replace the index there. Returns
/// different minima, the best first; none if no site is far enough from the boundary, or inner loops
/// are closer to each other than the sites.
std::vector<SearchedConfiguration> SearchConfigurations(
  const PlanarDomain& domain, const ProposalOptions& options = {}, const Progress& progress = {});
}
