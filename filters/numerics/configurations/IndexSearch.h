#pragma once

#include "CandidateSites.h"
#include "IndexForm.h"
#include "Progress.h"

namespace crossfield
{
/// Quarter indices at the positions of CandidateSites.
struct SiteIndices
{
  Eigen::VectorXi indices;
  /// Number of elements of the group that map the indices to themselves.
  std::size_t symmetries = 1;
  /// The quadratic form with the energy of the holonomy defects, less the worth of the symmetries.
  double objective = 0.0;
};

/// Searches quarter indices at sites with a sum for minima of the energy
/// (docs/method.md §5.10), for every symmetry of the sites separately. Two sites closer than `apart`
/// are not used together, and no index exceeds 1 except at a fixed point of a symmetry. Returns
/// different results, those first with the lowest objectives.
std::vector<SiteIndices> SearchIndices(
  const CandidateSites& sites, const IndexForm& form, double apart, const Progress& progress = {});
}
