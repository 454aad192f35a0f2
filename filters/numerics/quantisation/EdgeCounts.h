#pragma once

#include <algorithm>
#include <vector>

namespace crossfield
{
/// Returns a bound on the rounding errors of a cost, which is a sum of products. It is far below
/// the change of cost by one edge.
constexpr double CostRounding(double cost)
{
  return 1e-9 * (1.0 + cost);
}

/// A solution of a QuantisationProblem: the edge counts of all arcs, and what is proved about them.
/// All searches of this module return it; those that prove nothing leave `bound` and `optimal` as
/// they are.
struct EdgeCounts
{
  std::vector<int> counts; ///< n_a per arc.
  double cost = 0.0;       ///< Σ w_a |n_a − ℓ_a|.
  double bound = 0.0;      ///< Proved lower bound of the cost.
  bool optimal = false;    ///< Whether the search proved that no counts cost less.
  int nodes = 0;           ///< Nodes of the search: flows, or relaxations of branch and cut.
  double size = 0.0;       ///< Target edge length in the map that the problem was made for, if any.
  double seconds = 0.0;

  /// Returns (cost − bound) / (1 + bound), 0 if the counts are optimal.
  double Gap() const
  {
    return this->optimal ? 0.0 : std::max(0.0, (this->cost - this->bound) / (1.0 + this->bound));
  }

  /// Returns whether the cost equals the bound, up to rounding.
  bool IsProved() const { return this->cost <= this->bound + CostRounding(this->bound); }

  /// Returns the number of arcs without edges.
  int ZeroArcs() const
  {
    return static_cast<int>(std::count(this->counts.begin(), this->counts.end(), 0));
  }

  /// Returns whether other counts cost less, by more than rounding.
  bool IsImprovedBy(const EdgeCounts& other) const
  {
    return other.cost < this->cost - CostRounding(this->cost);
  }
};
}
