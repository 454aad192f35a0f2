#pragma once

#include "MeshTopology.h"

#include <Eigen/SparseCore>

namespace crossfield
{
/// Assembles the stiffness matrix of continuous piecewise linear functions: K_vw = ∫ ∇λ_v · ∇λ_w
/// (docs/method.md §2.1).
///
/// Rows and columns are the vertices of the mesh. The matrix is symmetric with both triangles
/// stored, compressed, and positive semidefinite with the constants as kernel; it is invariant
/// under scaling of the mesh. Throws Error for a triangle without area.
Eigen::SparseMatrix<double> P1Stiffness(const MeshTopology& topology);

/// Returns the element matrix of a triangle with corners in any plane. Throws Error as above.
Eigen::Matrix3d P1ElementStiffness(const std::array<Point, 3>& corners);
}
