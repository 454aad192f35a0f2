#pragma once

#include "CutGraph.h"
#include "SeamlessMap.h"

#include <Eigen/SparseCore>

namespace crossfield
{
/// What ties the coordinates of a mesh that is cut open (docs/method.md §12.3), solved: all unknowns from
/// the free ones. Unknowns are u and v of vertex c, 2c and 2c + 1, and after them the two of each chain's
/// translation.
///
/// `seams`: of each chain the rotation from its left to its right; `directions` as in SeamlessMap; `cones` are
/// the vertices whose position the translations depend on.
Eigen::SparseMatrix<double, Eigen::RowMajor> EliminateSeams(const MeshTopology& topology,
  const CutGraph& cut, const std::vector<SeamTransition>& seams, const std::vector<int>& directions,
  const std::vector<Cone>& cones);

/// The triangle on the left of the way from one vertex to another along an edge; −1 where there is none.
int TriangleLeftOf(const MeshTopology& topology, int edge, int from);
}
