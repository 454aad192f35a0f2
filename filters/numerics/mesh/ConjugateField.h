#pragma once

#include "LogSource.h"
#include "MeshTopology.h"

#include <Eigen/Core>

namespace crossfield
{
/// Computes the Crouzeix-Raviart functions w_c with ∇w_c = rot g_c on every triangle, where rot is
/// the rotation by +90°, and with given values on one edge (docs/method.md §2.2, discrete
/// conjugacy). Values are integrated from edge to edge, in breadth-first order.
///
/// `gradients` has one column per triangle and two rows per function: the gradients of P1
/// potentials, with or without periods. The result has one column per edge and one row per
/// function. Where w is multivalued, the branch on an edge is that of the shortest path from the
/// first edge. `logs` are added to every potential, in the plane only; they contribute the
/// angles under which their centres see each step.
Eigen::MatrixXd IntegrateConjugate(const MeshTopology& topology, const Eigen::MatrixXd& gradients,
  int firstEdge, const Eigen::VectorXd& firstValues, const std::vector<LogSource>& logs = {});

/// Returns ½ ∫ Σ_c |g_c|² for fields that are constant on each triangle.
double GradientEnergy(const MeshTopology& topology, const Eigen::MatrixXd& gradients);
}
