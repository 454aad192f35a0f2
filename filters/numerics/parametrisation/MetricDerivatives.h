#pragma once

#include "ConeMetric.h"

#include <Eigen/SparseCore>

#include <vector>

namespace crossfield
{
/// Derivatives of the angles of a metric with respect to the logarithms x of edge lengths, at the
/// metric with which it was constructed (docs/method.md §12.4):
///   dα_i = (cot_j + cot_k) dx_i − cot_k dx_j − cot_j dx_k, x_i opposite to vertex i.
/// With G = d(angle sums) / dx and B the conformal changes, (B u)_ab = (u_a + u_b) / 2, the matrix
/// G B is minus the cotangent Laplacian of the metric.
class MetricDerivatives
{
public:
  explicit MetricDerivatives(const ConeMetric& metric);

  const ConeMetric& GetMetric() const { return this->Metric; }
  const MetricAngles& AnglesOf(int triangle) const { return this->Angles[triangle]; }

  /// Returns, per vertex, the angle that it should have minus the sum of its angles, in radians.
  Eigen::VectorXd AngleDefects() const;
  /// Returns G x.
  Eigen::VectorXd AngleSumChanges(const Eigen::VectorXd& edges) const;
  /// Returns Gᵀ a.
  Eigen::VectorXd Pullback(const Eigen::VectorXd& vertices) const;
  /// Returns the cotangent Laplacian −G B, positive semidefinite, both triangles stored.
  Eigen::SparseMatrix<double> Laplacian() const;

  /// An edge and a coefficient.
  using Term = std::pair<int, double>;
  /// Returns the derivative of one angle.
  std::array<Term, 3> AngleDerivative(int triangle, int corner) const;

private:
  const ConeMetric& Metric;
  std::vector<MetricAngles> Angles;
};

/// Returns B u, per edge.
Eigen::VectorXd ConformalChanges(const ConeMetric& metric, const Eigen::VectorXd& vertices);
/// Returns Bᵀ x, per vertex.
Eigen::VectorXd ConformalPullback(const ConeMetric& metric, const Eigen::VectorXd& edges);
}
