#pragma once

#include "CrouzeixRaviart.h"
#include "MeshTopology.h"

namespace crossfield
{
/// The Crouzeix-Raviart space with u = e^{4iτ} on every edge of the outer and inner loops, and its
/// stiffness matrix: what every direct solve for u starts from.
struct AlignedProblem
{
  SparseMatrix stiffness;     ///< Over all edges.
  std::vector<int> free;      ///< Edges whose value is not prescribed, in increasing order.
  std::vector<int> fixed;     ///< The others,
  ComplexVector prescribed;   ///< and their values.
  SparseMatrix freeStiffness; ///< Rows and columns along free.
  std::vector<Point> places;  ///< Midpoints of the free edges.

  /// `weights`: see CrouzeixRaviartStiffness.
  explicit AlignedProblem(const MeshTopology& topology, const Eigen::VectorXd& weights = {});

  /// Sets the values on the fixed edges.
  void Align(ComplexVector& u) const;

  /// Nested dissection of the free edges, with the positions `trailing` in free at the end.
  std::vector<int> EliminationOrder(const std::vector<int>& trailing = {}) const;

  /// Sources of the free edges from the prescribed values: columns Re and Im.
  Eigen::MatrixXd Load() const;

  /// The field on all edges with these values on the free ones: columns Re and Im.
  ComplexVector Extend(const Eigen::MatrixXd& values) const;

  /// Least ½ ∫ w |∇u|².
  ComplexVector HarmonicField() const;
};
}
