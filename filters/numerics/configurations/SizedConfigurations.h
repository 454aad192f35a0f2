#pragma once

#include "PlanarDomain.h"
#include "Progress.h"
#include "SizeSearchOptions.h"

#include <vector>

namespace crossfield
{
/// Singularities with which sizes are near to target sizes.
struct SizedConfiguration
{
  Configuration singularities; ///< Given ones first.
  /// Standard deviation of the logarithm of size over target size, half by area and half by quads.
  double spread = 0.0;
  std::size_t symmetries = 1; ///< Of the domain with its target sizes that the singularities have.
};

/// Returns the spread of the given singularities.
double SpreadOfSizes(const PlanarDomain& domain, const SizeSearchOptions& options);

/// Searches the singularities whose field has target sizes s with few nodes (docs/method.md §5.11): minima of
///   10⁴ ½ |H − log s|² + ε W + γ Σ |k|
/// over the quarter indices k at sites about 1.6 quads apart, for a descending cost γ of a node, whose
/// positions are then refined to a fifth of a quad. Returns different configurations, sorted by their
/// number of nodes. Unless singularities are given, none has more nodes than another one with a spread of
/// at most 0.15. Returns none if no site is far enough from the boundary.
std::vector<SizedConfiguration> SearchForSizes(
  const PlanarDomain& domain, const SizeSearchOptions& options, const Progress& progress = {});
}
