#pragma once

#include "TMesh.h"

#include <string>
#include <utility>

namespace crossfield
{
/// The term ± n_a of an arc in an equation: + on one of two opposite sides of a patch, − on the
/// other.
struct EquationTerm
{
  int equation = 0;
  int sign = 1;
};

/// A prescribed sum of edge counts, or the difference of those of paired sides:
/// minimum ≤ Σ factor · n_a ≤ maximum.
struct CountSum
{
  std::vector<std::pair<int, int>> terms; ///< Arc and factor; every arc at most once.
  int minimum = 0;
  int maximum = 0;
  std::string name; ///< What prescribes it, for messages; several sums may share one.

  bool Holds(const std::vector<int>& counts) const;
};

/// The integer program for the edge counts of a T-mesh (docs/method.md §14.1): minimise Σ w_a |n_a
/// − ℓ_a| over integers n_a ≥ lower_a, with one equation per pair of opposite sides of a patch.
/// Every arc is in at most two equations, each time with coefficient ±1, so this is a bidirected
/// flow, apart from sums that are prescribed. Separation rows (SeparationRow.h) are added by the search.
struct QuantisationProblem
{
  std::vector<double> target; ///< ℓ_a, the target edge count of each arc.
  std::vector<double> weight; ///< w_a > 0.
  std::vector<int> lower;
  std::vector<std::vector<EquationTerm>> terms; ///< Per arc; two terms that cancel are left out.
  int equations = 0;
  std::vector<CountSum> sums;

  std::size_t Count() const { return this->target.size(); }
  /// Returns w_a |count − ℓ_a| of one arc.
  double Cost(std::size_t arc, int count) const;
  /// Returns the objective.
  double Cost(const std::vector<int>& counts) const;
  /// Returns whether all prescribed sums hold.
  bool HoldsSums(const std::vector<int>& counts) const;
  /// Returns whether all equations, bounds and prescribed sums hold.
  bool IsFeasible(const std::vector<int>& counts) const;
};

/// Makes the problem for target counts ℓ_a. w_a is half the sum of the widths of the two patches
/// beside the arc, measured in target counts as well, so that the objective is a number of quads.
QuantisationProblem MakeQuantisationProblem(const TMesh& mesh, std::vector<double> target);

/// Replaces target counts by ones that fulfil the equations of the patches and those sums that equate counts, by
/// iterative proportional fitting: equal sums become their geometric mean, with the weights of their arcs.
/// Without it, any count between the targets at both ends of a strip costs the same.
void BalanceTargets(const TMesh& mesh, QuantisationProblem& problem);

/// Returns the problem with equations instead of sums Σ ± n_a = 0 whose arcs are in one equation each, as
/// those of paired sides are: an arc of the boundary is in one equation of a patch. The problem is a flow
/// if no sums are left.
QuantisationProblem WithSumsAsEquations(QuantisationProblem problem);

/// Makes the problem for quads of edge length `size` in the map: ℓ_a = L_a / size.
QuantisationProblem MakeQuantisationProblem(const TMesh& mesh, double size);
}
