#pragma once

#include "PlanarTopology.h"

#include <Eigen/Core>

namespace crossfield
{
/// Returns sizes at all vertices of a mesh from those on its boundary: inside, the logarithm of the
/// size is the harmonic P1 function, smooth and between the minimum and maximum given
/// (docs/method.md §14.8). Entries of inner vertices are ignored.
Eigen::VectorXd ExtendSizes(const PlanarTopology& topology, const Eigen::VectorXd& sizes);

/// Returns the uniform size that gives as many quads as the given sizes: √(A / ∫ dA / h²),
/// integrated at the vertices. Divided by it, sizes have no unit.
double EquivalentSize(const TriangleMesh& mesh, const Eigen::VectorXd& sizes);
}
