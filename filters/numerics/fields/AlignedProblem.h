#pragma once

#include "CrouzeixRaviart.h"
#include "PlanarTopology.h"

namespace crossfield
{
/// Crouzeix-Raviart space with u = e^{4iτ} prescribed on every edge of the outer and inner loops,
/// and its stiffness matrix: the common part of all direct solves for u.
struct AlignedProblem
{
  SparseMatrix stiffness;         ///< Stiffness matrix over all edges.
  std::vector<int> free;          ///< Edges whose value is not prescribed, in increasing order.
  std::vector<int> fixed;         ///< Edges whose value is prescribed.
  ComplexVector prescribed;       ///< Values on the fixed edges.
  SparseMatrix freeStiffness;     ///< Rows and columns of the free edges.
  std::vector<SpacePoint> places; ///< Midpoints of the free edges.

  /// Assembles the problem. `weights`: see CrouzeixRaviartStiffness.
  explicit AlignedProblem(const PlanarTopology& topology, const Eigen::VectorXd& weights = {});

  /// Sets the values on the fixed edges.
  void Align(ComplexVector& u) const;

  /// Returns the nested dissection order of the free edges; `trailing` are positions in `free` that
  /// come last.
  std::vector<int> EliminationOrder(const std::vector<int>& trailing = {}) const;

  /// Returns the right-hand side on the free edges due to the prescribed values: columns Re and Im.
  Eigen::MatrixXd Load() const;

  /// Returns the field on all edges that has the given values on the free edges: columns Re and Im.
  ComplexVector Extend(const Eigen::MatrixXd& values) const;

  /// Returns the minimiser of ½ ∫ w |∇u|².
  ComplexVector HarmonicField() const;
};
}
