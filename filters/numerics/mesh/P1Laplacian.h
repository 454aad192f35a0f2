#pragma once

#include "EdgeNumbering.h"

#include <Eigen/SparseCore>

namespace crossfield
{
/// Stiffness matrix of continuous piecewise linear functions: K_vw = ∫ ∇λ_v · ∇λ_w (docs/method.md §2.1).
///
/// Rows and columns are the vertices of the mesh. Symmetric, both halves stored, compressed;
/// positive semidefinite with the constants as kernel; independent of the mesh's size. Throws Error
/// for a triangle without area.
Eigen::SparseMatrix<double> P1Stiffness(const TriangleMesh& mesh, const EdgeNumbering& edges);

/// Element matrix of triangle t in the order of its vertices.
Eigen::Matrix3d P1ElementStiffness(const TriangleMesh& mesh, std::size_t t);
}
