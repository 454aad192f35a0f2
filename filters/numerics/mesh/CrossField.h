#pragma once

#include "CrouzeixRaviart.h"
#include "MeshTopology.h"

namespace crossfield
{
/// A Crouzeix-Raviart cross field on a mesh (docs/method.md §1, §2.1).
struct CrossField
{
  SharedTopology topology;
  ComplexVector u; ///< Representation, about e^{4iθ}, at each edge.
};

/// The phase 4θ of a cross field without the ambiguity of 2π, as far as that is possible.
struct UnwrappedPhase
{
  /// arg u + 2π n at each edge, n integer. Along a tree over all edges it goes by the shortest way from
  /// one edge of a triangle to the next.
  Eigen::VectorXd atEdges;
  /// Per triangle, for its sides p0p1, p1p2, p2p0: by how many turns the phase on the next side differs
  /// from that of this side plus the shortest way. In quarters of a turn of the cross; zero on the tree,
  /// and the sum over a triangle is minus its index.
  std::vector<std::array<int, 3>> matching;
};

/// Computed breadth-first from an edge of the outer loop. Throws Error when there is none, or the field
/// has no direction at an edge.
UnwrappedPhase UnwrapPhase(const CrossField& field);
}
