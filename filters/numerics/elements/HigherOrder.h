#pragma once

#include "Progress.h"
#include "StraightQuads.h"

#include <vector>

namespace crossfield
{
/// Quads of a higher order with Lagrange nodes at equal steps.
struct CurvedQuads
{
  int order = 2;
  std::vector<Point> points; ///< Those of the straight quads first.
  /// Per quad, (order + 1)² nodes: those of the row from point 0 to point 1 first, the row from
  /// point 3 to point 2 last.
  std::vector<std::vector<int>> quads;
  /// Per boundary edge, its order + 1 nodes from end to end.
  std::vector<std::vector<int>> edges;

  // Quality.
  std::vector<double>
    jacobianRatios;            ///< Per quad, the minimum over the maximum of det J at Gauss points.
  double jacobianRatio = 1.0;  ///< Their minimum.
  int inverted = 0;            ///< Quads with det J ≤ 0 at a Gauss point.
  Point worst = Point::Zero(); ///< Centre of the quad with the smallest ratio.
  int curvedRows = 0; ///< Largest number of rows of quads beside the boundary with curved edges.
  /// Per curve, the largest distance of a node from the straight edge.
  std::vector<double> sagittas;
};

/// Curves quads (docs/method.md §17.5): the nodes of a boundary edge are on its curve, those inside
/// a quad follow by transfinite interpolation. Where that leaves det J at one of the (order + 1)² Gauss
/// points below half of its minimum in the straight quad, the edges opposite to the boundary edge are
/// curved as well, with a part that decreases linearly over as many rows as are needed. Nodes on the
/// second of two periodic sides are the images of those on the first.
///
/// Throws Error if the order is neither 2 nor 3, an edge has more than two quads, or a boundary edge
/// belongs to no quad, and as MatchEdges does.
CurvedQuads RaiseOrder(const StraightQuads& straight, int order, const Progress& progress = {});
}
