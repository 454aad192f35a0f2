#pragma once

#include "EdgeNumbering.h"

#include <Eigen/SparseCore>

#include <complex>

namespace crossfield
{
using Complex = std::complex<double>;
using ComplexVector = Eigen::VectorXcd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Assembles the stiffness matrix of the Crouzeix-Raviart space: K_ij = ∫ ∇ψ_i · ∇ψ_j summed over
/// triangles, where ψ_e = 1 − 2λ_v is 1 at the midpoint of edge e, −1 at the opposite vertex v and
/// 0 at the midpoints of the other two edges (docs/method.md §2.1; Crouzeix and Raviart 1973).
///
/// Rows and columns are edges. The matrix is symmetric with both triangles stored, and positive
/// semidefinite; its kernel consists of the constants of each connected part. It is four times the
/// P1 element matrix and invariant under scaling and rotation of the mesh. `weights`, if not empty,
/// has a factor for the integral over each triangle. Throws Error for a triangle without area.
SparseMatrix CrouzeixRaviartStiffness(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const Eigen::VectorXd& weights = {});

/// Returns the representation e^{4iτ} of the crosses aligned with a direction of angle τ.
Complex AlignedRepresentation(const Point& direction);
}
