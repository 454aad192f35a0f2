#pragma once

#include "MeshTopology.h"

#include <Eigen/Core>

namespace crossfield
{
/// Returns the largest P1 function that is not above given values at the vertices and grows by at most
/// `growth` per unit of distance inside the mesh (docs/method.md §14.8):
///   s(x) = min_y (s₀(y) + growth · d(x, y)).
/// Values that are infinite are replaced from elsewhere.
///
/// In every triangle, s at a corner is at most the minimum over the opposite side of the linear
/// function there plus growth times the distance (Hopf-Lax formula), and vertices are taken by
/// increasing value as in Dijkstra's algorithm, again where a later one lowers them (triangles may
/// be obtuse). Cost: n log n.
Eigen::VectorXd LimitGrowth(
  const MeshTopology& topology, const Eigen::VectorXd& values, double growth);
}
