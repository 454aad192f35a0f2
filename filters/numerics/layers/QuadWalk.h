#pragma once

#include "QuadMesh.h"

namespace crossfield
{
/// The sides of the quads of a mesh, numbered as in QuadMesh::Twins, and the steps between them.
class QuadWalk
{
public:
  explicit QuadWalk(const QuadMesh& mesh);

  int StartOf(int side) const;
  int EndOf(int side) const;
  static int Next(int side) { return side / 4 * 4 + (side + 1) % 4; }
  static int Previous(int side) { return side / 4 * 4 + (side + 3) % 4; }
  static int Opposite(int side) { return side / 4 * 4 + (side + 2) % 4; }
  /// Returns the other side of the same edge, −1 on the boundary.
  int Twin(int side) const { return this->Twins[side]; }

  // Rows of quads run along sides, with the quads on the left.

  /// Returns the next side along a row, −1 at the boundary.
  int Forward(int side) const;
  /// Returns the previous side along a row, −1 at the boundary.
  int Backward(int side) const;
  /// Returns the sides along the row through a side, from the boundary to the boundary or once
  /// around.
  std::vector<int> RowThrough(int side) const;
  /// Returns the side of the quad behind, which is opposite, −1 at the boundary.
  int Above(int side) const { return this->Twin(Opposite(side)); }

  /// Returns the height of a quad above a side: the mean length of the sides next to it.
  double Height(int side) const;
  /// Returns the side of a quad on each edge of mesh.boundary.
  std::vector<int> OfBoundary() const;

private:
  const QuadMesh& Mesh;
  std::vector<int> Twins;
};
}
