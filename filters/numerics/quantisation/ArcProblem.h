#pragma once

#include "TMesh.h"

namespace crossfield
{
/// An arc in the equation of a pair of opposite sides: + on the one, − on the other.
struct ArcTerm
{
  int row = 0;
  int sign = 1;
};

/// How many edges of quads every arc gets (docs/method.md §14.1): minimise Σ w_a |n_a − ℓ_a| over integers
/// n_a ≥ lower_a with one equation per pair of opposite sides. Every arc is in two equations at most, each
/// time with ±1, so this is a bidirected flow.
struct ArcProblem
{
  std::vector<double> wanted; ///< ℓ_a.
  std::vector<double> weight; ///< w_a > 0.
  std::vector<int> lower;
  std::vector<std::vector<ArcTerm>> terms; ///< Per arc; two that cancel are left out.
  int rows = 0;

  std::size_t Count() const { return this->wanted.size(); }
  /// w |n − ℓ| of one arc.
  double Cost(std::size_t arc, int count) const;
  double Cost(const std::vector<int>& counts) const;
  /// Whether all equations and bounds hold.
  bool Allows(const std::vector<int>& counts) const;
};

/// Costs are sums of products: this is far below what an edge more or less makes.
constexpr double CostRounding(double cost)
{
  return 1e-9 * (1.0 + cost);
}

/// The problem for wanted counts ℓ_a. w_a is half the widths of the two faces beside the arc, counted in wanted edges
/// as well, so that the residual is a number of quads.
ArcProblem MakeArcProblem(const TMesh& mesh, std::vector<double> wanted);

/// For quads of edge length `size` in the map: ℓ_a = L_a / size.
ArcProblem MakeArcProblem(const TMesh& mesh, double size);
}
