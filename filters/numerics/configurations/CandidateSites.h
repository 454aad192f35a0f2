#pragma once

#include "BoundarySymmetry.h"
#include "TargetSize.h"

#include <vector>

namespace crossfield
{
/// Positions at which singularities may be, closed under the symmetries of a domain.
struct CandidateSites
{
  SymmetryGroup group;
  std::vector<Isometry> elements; ///< Of the group, the identity first.
  std::vector<Point> positions;
  /// For each element and each position, the position that it is mapped to.
  std::vector<std::vector<std::size_t>> images;
};

/// Returns the symmetries of the curves of a domain, with at most twelve rotations.
SymmetryGroup SearchedSymmetries(const PlanarDomain& domain);

/// Selects sites among places, the first ones with precedence, and adds their images under symmetries. They
/// are at least 1.6 target sizes apart and 1.3 from the boundary. The maximum number is 900; if there were
/// more, they are farther apart.
CandidateSites FindSitesForSizes(const PlanarDomain& domain, const SymmetryGroup& symmetries,
  const std::vector<Point>& places, const SizeFunction& size);

/// Returns places and their images under some symmetries of a domain, at least 1 target size from the
/// boundary, in any case the first `kept` of them.
CandidateSites CloseUnderSymmetries(const PlanarDomain& domain,
  const std::vector<Isometry>& symmetries, const std::vector<Point>& places, std::size_t kept,
  const SizeFunction& size);

/// Returns the sites of the search of docs/method.md §5.10: around round holes, along the axes of
/// reflections, and a lattice that is finer where the boundary is closer. All are at least
/// `clearance` away from the boundary.
CandidateSites FindCandidateSites(const PlanarDomain& domain, double clearance);
}
