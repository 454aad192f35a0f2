#pragma once

#include "EdgeNumbering.h"
#include "LogSource.h"

#include <Eigen/Core>

namespace crossfield
{
/// Crouzeix-Raviart functions w_c with ∇w_c = rot g_c on every triangle, rot = +90°, and given values
/// on one edge (docs/method.md §2.2, discrete conjugacy): summed along edges, in breadth-first order.
///
/// `gradients` has one column per triangle and two rows per function, the gradients of P1 potentials
/// with or without periods. The result has one column per edge and one row per function. Where w is
/// multivalued the branch on an edge is that of the shortest way from the first edge. `logs` are added
/// to every potential: the angles at which their centres see the steps.
Eigen::MatrixXd IntegrateConjugate(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const Eigen::MatrixXd& gradients, int firstEdge, const Eigen::VectorXd& firstValues,
  const std::vector<LogSource>& logs = {});

/// ½ ∫ Σ_c |g_c|² of fields that are constant on every triangle.
double GradientEnergy(const TriangleMesh& mesh, const Eigen::MatrixXd& gradients);
}
