#pragma once

#include "Plane.h"
#include "Progress.h"
#include "SolverMesh.h"

#include <array>
#include <functional>
#include <vector>

namespace crossfield
{
/// Shapes of quads of a higher order, and how far they follow the boundary.
struct OrderQuality
{
  std::vector<double>
    jacobianRatios;           ///< Per quad, the minimum over the maximum of det J at Gauss points.
  double jacobianRatio = 1.0; ///< Their minimum.
  int inverted = 0;           ///< Quads with det J ≤ 0 at a Gauss point.
  SpacePoint worst = SpacePoint::Zero(); ///< Centre of the quad with the smallest ratio.
  int curvedRows = 0; ///< Largest number of rows of quads beside the boundary with curved edges.
  /// Per curve, the largest distance of a node from the straight edge, in the unit of the points.
  std::vector<double> sagittas;
};

/// Returns the point of a surface nearest to a place in a quad of the mesh with the given corners; if the place is on an
/// edge, which leads from the first corner to the second, that is on the boundary of the mesh or on a line inside that
/// has a side, the nearest point of the lines of the surface.
using NodePlacement = std::function<SpacePoint(
  const SpacePoint& place, const std::array<int, 4>& corners, bool isOnLine)>;

/// Returns quads of order 2 or 3 from those of order 1, with Lagrange nodes at equal steps; the points of the given
/// quads come first. `quality` receives measures.
///
/// The nodes of a boundary edge are on its curve, those inside a quad follow by transfinite interpolation
/// (docs/method.md §17.5). Where that leaves det J at one of the (order + 1)² Gauss points below half of its minimum
/// in the straight quad, the edges opposite to the boundary edge are curved as well, with a part that decreases
/// linearly over as many rows as are needed. Nodes on the second of two periodic sides are the images of those on
/// the first.
///
/// On a surface, every node is placed on it from where it is on straight edges, or by the formula of Coons inside, and
/// det J is that in the plane of the diagonals of the quad; there are no curves.
///
/// Throws Error if the order is neither 2 nor 3, the mesh has other cells than quads of order 1, they are not in a
/// plane or on a surface, or an edge has more than two, and as MeshFaces and MatchPair do.
SolverMesh RaiseOrder(const SolverMesh& quads, int order, OrderQuality& quality,
  const Progress& progress = {}, const NodePlacement& surface = {});
}
