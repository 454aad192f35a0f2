#pragma once

#include "CutGraph.h"
#include "SeamlessMap.h"

#include <Eigen/SparseCore>

namespace crossfield
{
/// Solves the equations of seams and of boundary sides between the coordinates of a cut mesh
/// (docs/method.md §12.3). Returns the matrix that maps the free unknowns to all: u and v of vertex
/// c are unknowns 2c and 2c + 1; after them come the two components of each chain's translation.
///
/// `seams` has for each chain the rotation from its left to its right; `directions` as in
/// SeamlessMap. The coordinates of `cones` are eliminated last, so the translations are expressed
/// by them.
Eigen::SparseMatrix<double, Eigen::RowMajor> EliminateSeams(const MeshTopology& topology,
  const CutGraph& cut, const std::vector<SeamTransition>& seams, const std::vector<int>& directions,
  const std::vector<Cone>& cones);

/// Returns the triangle on the left of an edge that is directed from vertex `from` to its other
/// vertex; −1 where there is none.
int TriangleLeftOf(const MeshTopology& topology, int edge, int from);
}
