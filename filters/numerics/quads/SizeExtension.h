#pragma once

#include "MeshTopology.h"

#include <Eigen/Core>

namespace crossfield
{
/// Sizes at the vertices of a mesh from those on its boundary, which are kept: inside the logarithm of
/// the size is harmonic (P1), so that it is smooth and between the least and the largest given
/// (docs/method.md §14.8). Entries of inner vertices are ignored.
Eigen::VectorXd ExtendSizes(const MeshTopology& topology, const Eigen::VectorXd& sizes);

/// The side of equal quads that are as many as quads of the given sizes: sqrt(A / ∫ dA / h²), by the vertices.
/// Relative to it sizes have no unit.
double EquivalentSize(const TriangleMesh& mesh, const Eigen::VectorXd& sizes);
}
