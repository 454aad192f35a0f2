#pragma once

#include "MeshTopology.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// Reads the quarter indices of a field with one cross per triangle, on any mesh (docs/method.md §22.7): at a vertex
///   k_v = (D_v + 4 K_v) / 2π inside, (D_v + 4 τ_v) / 2π on the boundary,
/// D_v the sum of the wrapped changes of 4θ from triangle to triangle around it, less 4 times the hinges, on the boundary
/// with the steps from and to the directions of its edges. `angle` has θ in the chart of each triangle,
/// radians. Σ k = 4χ for every field.
std::vector<int> ReadSurfaceIndices(const MeshTopology& topology, const Eigen::VectorXd& angle);

/// A singularity of a field at a vertex of a surface.
struct VertexSingularity
{
  int vertex = 0;
  int quarterIndex = 0;
  int loop = -1; ///< Entry of MeshTopology::loops, −1 inside.
};

/// Returns the singularities of a field: those inside, sorted by vertex, then those of the boundary. Singular vertices inside
/// that edges connect are one, at that of the largest index; pairs that cancel are none. Corners of
/// the boundary are left out unless `includesCorners` is set.
std::vector<VertexSingularity> FindSurfaceSingularities(
  const MeshTopology& topology, const Eigen::VectorXd& angle, bool includesCorners);

/// Returns the number of singularities of a field besides given quarter indices of the vertices, and of those that it
/// lacks.
int CountUnwanted(
  const MeshTopology& topology, const Eigen::VectorXd& angle, const std::vector<int>& quarters);

/// Returns the angles in the charts of triangles of directions in space. Throws Error if one has no component along its
/// triangle.
Eigen::VectorXd AnglesInCharts(
  const MeshTopology& topology, const std::vector<SpacePoint>& directions);
}
