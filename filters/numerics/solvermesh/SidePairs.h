#pragma once

#include "MeshFaces.h"

#include <array>
#include <map>
#include <vector>

namespace crossfield
{
/// The nodes and faces of two sides that match.
struct PairMatch
{
  /// Per point of the first side, also inside edges and faces of higher order, the point of the second side that
  /// the motion takes it to.
  std::map<int, int> nodes;
  /// Per face of the first side, in the order of MeshFaces::OfSide, the index in OfSide of that of the second.
  std::vector<int> faces;
};

/// Matches the sides of a pair.
///
/// Throws Error if they have different numbers of points or other faces, or a point has no image within 1e-9 of the
/// mesh's extent.
PairMatch MatchPair(const SolverMesh& mesh, const MeshFaces& faces, const SidePair& pair);
}
