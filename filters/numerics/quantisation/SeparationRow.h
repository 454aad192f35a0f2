#pragma once

#include "ArcPoints.h"

#include <utility>
#include <vector>

namespace crossfield
{
/// Σ factor n_arc ≥ least.
struct ArcRow
{
  std::vector<std::pair<int, int>> terms; ///< Arc and factor.
  int least = 1;

  bool Holds(const std::vector<int>& counts) const;
  bool operator==(const ArcRow& other) const
  {
    return this->terms == other.terms && this->least == other.least;
  }
};

/// The row that keeps the ends of a way of links apart: that a displacement in the signs of the real one, whose sides are
/// `wanted`, is 1 at least; towards a boundary only across it (docs/method.md §14.3). Without terms where the way has
/// none: between two sides of the boundary that are not parallel, or ends that are not apart in the map.
ArcRow SeparateEnds(const TMesh& mesh, const std::vector<int>& counts,
  const std::vector<double>& wanted, const std::vector<PointLink>& way);
}
