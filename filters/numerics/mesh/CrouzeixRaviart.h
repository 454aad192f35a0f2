#pragma once

#include "EdgeNumbering.h"

#include <Eigen/SparseCore>

#include <complex>

namespace crossfield
{
using Complex = std::complex<double>;
using ComplexVector = Eigen::VectorXcd;
using SparseMatrix = Eigen::SparseMatrix<double>;

/// Stiffness matrix of the Crouzeix-Raviart space: K_ij = ∫ ∇ψ_i · ∇ψ_j summed over triangles,
/// where ψ_e = 1 − 2λ_v is 1 at the midpoint of edge e, −1 at the opposite vertex v, and 0 at the
/// midpoints of the other two edges (docs/method.md §2.1; Crouzeix and Raviart 1973).
///
/// Rows and columns are edges. Symmetric, both halves stored; positive semidefinite with the
/// constants of each connected part as kernel; four times the P1 element matrix; in the plane it
/// does not change when the mesh is scaled or rotated. `weights`, if not empty, has a factor for the
/// integral over each triangle. Throws Error for a triangle without area.
SparseMatrix CrouzeixRaviartStiffness(
  const TriangleMesh& mesh, const EdgeNumbering& edges, const Eigen::VectorXd& weights = {});

/// Representation e^{4iτ} of the crosses aligned with a direction of angle τ.
Complex AlignedRepresentation(const Point& direction);
}
