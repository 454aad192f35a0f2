#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// The quads within some rings around the singularities and irregular corners of a mesh, and around its inverted quads, as a mesh of
/// their own.
struct QuadPart
{
  QuadMesh mesh;
  std::vector<bool> moves;         ///< Those of the whole, but on the rim.
  std::vector<std::size_t> points; ///< Of the whole.

  /// `moves`: which points of the whole do.
  QuadPart(const QuadMesh& whole, const std::vector<bool>& wholeMoves, int rings);
  /// Puts the points of the whole where those of the part are.
  void PutBack(QuadMesh& whole) const;
};
}
