#pragma once

#include "MeshTopology.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// Reads the quarter indices of a field with one cross per triangle, on any mesh (docs/method.md §22.7): at a vertex
///   k_v = (D_v + 4 K_v) / 2π inside, (D_v + 4 τ_v) / 2π on the boundary,
/// D_v the sum of the wrapped changes of 4θ from triangle to triangle around it, less 4 times the hinges, on the boundary
/// with the steps from and to the directions of its edges. `angle` has θ in the chart of each triangle, radians. Σ k = 4χ for every field.
std::vector<int> ReadSurfaceIndices(const MeshTopology& topology, const Eigen::VectorXd& angle);

/// Joins the indices of vertices inside that edges connect to the one with the largest index: singularities of a
/// field are found up to a triangle, and pairs that cancel are none.
void JoinNeighbours(const MeshTopology& topology, std::vector<int>& quarters);
}
