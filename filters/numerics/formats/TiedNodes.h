#pragma once

#include "MeshFaces.h"

#include <Eigen/Core>

#include <vector>

namespace crossfield
{
/// A point of a periodic side whose displacement is that of another point, turned: rotation · that
/// of the other. A point on the axis of the motion is its own image.
struct TiedNode
{
  int node = 0;
  int other = 0;
  Eigen::Matrix3d rotation = Eigen::Matrix3d::Identity();
};

/// Ties the points of periodic sides: all but one of those that the motions take to each other,
/// such as the four corners of a doubly periodic square, to the remaining one, which is tied to no
/// other. Throws Error as MatchPair does.
std::vector<TiedNode> TieNodes(const SolverMesh& mesh, const MeshFaces& faces);
}
