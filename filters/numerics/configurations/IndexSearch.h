#pragma once

#include "Progress.h"
#include "SiteOrbits.h"

#include <functional>

namespace crossfield
{
/// Quarter indices at the positions of CandidateSites.
struct SiteIndices
{
  Eigen::VectorXi indices;
  Subgroup kept; ///< Elements of the group that map the indices to themselves.
  /// The quadratic form with the energy of the holonomy defects, less the worth of the symmetries in
  /// SearchIndices.
  double objective = 0.0;
};

/// Searches quarter indices at sites with a sum for minima of the energy
/// (docs/method.md §5.10), for every symmetry of the sites separately. Two sites closer than `apart`
/// are not used together, and no index exceeds 1 except at a fixed point of a symmetry. Returns
/// different results, those first with the lowest objectives.
std::vector<SiteIndices> SearchIndices(
  const CandidateSites& sites, const IndexForm& form, double apart, const Progress& progress = {});

/// Searches minima of the energy and a cost for each node, for every symmetry of the sites and each of
/// several costs, which descend until a result is good enough: each search starts from the result of the one
/// before. A minimum is left by one of its kicks while that lowers the total. Returns different results.
std::vector<SiteIndices> SearchIndicesAtCosts(const CandidateSites& sites, const IndexForm& form,
  const SitePairs& isNear, const std::vector<double>& costs,
  const std::function<bool(const Eigen::VectorXi&)>& isEnough, const Progress& progress = {});

/// Moves indices to other sites as long as that lowers the energy, with some symmetries that they have.
SiteIndices ShiftIndices(const CandidateSites& sites, const IndexForm& form,
  const SitePairs& isNear, const Eigen::VectorXi& start, const Subgroup& symmetries);
}
