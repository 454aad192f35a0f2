#pragma once

#include "MeshTopology.h"

#include <Eigen/Core>

namespace crossfield
{
/// Returns |κ₁| + |κ₂| at the vertices of a surface (docs/method.md §22.13), per unit of length: of the tensor
///   (1 / 2A) Σ β |e| n nᵀ
/// of each triangle, the sum over its sides inside with the angle β between the normals and the normal n of the side
/// in the triangle, averaged over neighbours, which makes it independent of the triangles. Edges of the boundary are
/// not bent.
Eigen::VectorXd AbsoluteCurvature(const MeshTopology& topology);
}
