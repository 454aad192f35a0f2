#pragma once

#include "EdgeNumbering.h"
#include "LogSource.h"

#include <Eigen/Core>

namespace crossfield
{
/// The Crouzeix-Raviart function w with ∇w = rot g on every triangle, rot = +90°, and a given value
/// on one edge (METHOD §2, discrete conjugacy): summed along edges, in breadth-first order.
///
/// `gradients` has one column per triangle, the gradient of a P1 potential with or without periods.
/// Where w is multivalued the branch on an edge is that of the shortest way from the first edge.
/// `logs` are added to the potential: the angles at which their centres see the steps.
Eigen::VectorXd IntegrateConjugate(const TriangleMesh& mesh, const EdgeNumbering& edges,
  const Eigen::Matrix2Xd& gradients, int firstEdge, double firstValue,
  const std::vector<LogSource>& logs = {});

/// ½ ∫ |g|² of a field that is constant on every triangle.
double GradientEnergy(const TriangleMesh& mesh, const Eigen::Matrix2Xd& gradients);
}
