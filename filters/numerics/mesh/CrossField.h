#pragma once

#include "CrouzeixRaviart.h"
#include "PlanarTopology.h"

namespace crossfield
{
/// Crouzeix-Raviart cross field on a mesh (docs/method.md §1, §2.1).
struct CrossField
{
  SharedPlanarTopology topology;
  ComplexVector u; ///< Representation of the cross at each edge, approximately e^{4iθ}.
};

/// Phase 4θ of a cross field, unwrapped along a spanning tree of the edges.
struct UnwrappedPhase
{
  /// arg u + 2πn at each edge, n an integer. Along the tree, which joins edges of a common
  /// triangle, the phase changes by the difference in (−π, π].
  Eigen::VectorXd atEdges;
  /// For the sides p0p1, p1p2, p2p0 of each triangle: the number of turns by which the phase on the
  /// next side differs from the phase on this side plus the difference in (−π, π]. One unit is a
  /// quarter turn of the cross. The numbers are zero on the tree, and their sum over a triangle is
  /// minus its index.
  std::vector<std::array<int, 3>> matching;
};

/// Unwraps the phase, breadth-first from an edge of the outer loop. Throws Error if there is no
/// such edge, or if the field is zero or not finite at an edge.
UnwrappedPhase UnwrapPhase(const CrossField& field);
}
