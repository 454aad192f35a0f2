#pragma once

#include "BoundarySymmetry.h"

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

/// Returns the sites of the search of docs/method.md §5.10: around round holes, along the axes of
/// reflections, and a lattice that is finer where the boundary is closer. All are at least
/// `clearance` away from the boundary.
CandidateSites FindCandidateSites(const PlanarDomain& domain, double clearance);
}
