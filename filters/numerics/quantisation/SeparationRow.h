#pragma once

#include "ArcPoints.h"

#include <utility>
#include <vector>

namespace crossfield
{
/// The inequality Σ factor · n_arc ≥ minimum, which keeps two points of a T-mesh apart.
struct SeparationRow
{
  std::vector<std::pair<int, int>> terms; ///< Arc and factor.
  int minimum = 1;

  bool Holds(const std::vector<int>& counts) const;
  bool operator==(const SeparationRow& other) const
  {
    return this->terms == other.terms && this->minimum == other.minimum;
  }
};

/// Returns the row that keeps the ends of a path of links apart: their displacement, with the signs
/// that it has for the target counts, is at least 1; towards a boundary only its component across
/// counts (docs/method.md §14.3). The row has no terms if the path gives none: between two boundary
/// sides that are not parallel, or where the ends coincide in the map.
SeparationRow SeparateEnds(const TMesh& mesh, const std::vector<int>& counts,
  const std::vector<double>& target, const std::vector<PointLink>& path);

/// Returns the row that opens a closed path of links, which goes around a handle: the displacement of its unfolded end
/// from its start is at least 1, and at least 3 if one component of it is 0, because a line of two edges
/// would join the same points twice. The row has no terms if the path can be contracted.
SeparationRow OpenCycle(const TMesh& mesh, const std::vector<int>& counts,
  const std::vector<double>& target, const std::vector<PointLink>& path);
}
