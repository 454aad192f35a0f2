#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// A submesh: the quads within some rings around the singularities, irregular corners, periodic sides
/// and inverted quads of a mesh.
struct QuadPart
{
  QuadMesh mesh;
  std::vector<bool> moves;         ///< As in the full mesh, but false on the rim.
  std::vector<std::size_t> points; ///< Points of the full mesh.

  /// Extracts the submesh; `fullMoves` marks the points of the full mesh that may move.
  QuadPart(const QuadMesh& full, const std::vector<bool>& fullMoves, int rings);
  /// Copies the points of the submesh to the full mesh.
  void CopyPoints(QuadMesh& full) const;
};
}
