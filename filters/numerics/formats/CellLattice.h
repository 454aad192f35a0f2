#pragma once

#include <array>
#include <vector>

namespace crossfield
{
/// Positions in the lattice of nodes of a line, quad or hexahedron (ExportMesh.h), and their order in the
/// formats.
class CellLattice
{
public:
  CellLattice(int dimension, int order);

  /// Returns the position of a corner in VTK's order.
  int Corner(int corner) const;

  /// Returns the position that a position goes to if the first two indices change places.
  int Transposed(int position) const;

  int FaceCount() const { return this->Dimension == 2 ? 4 : 6; }

  /// Returns the positions of the nodes of a face, as a lattice whose normal points outwards; the
  /// edge of a quad has the quad on its left. Faces are numbered as in Abaqus, from 0.
  std::vector<int> Face(int face) const;

  /// Returns the positions of the corners of a face in VTK's order.
  std::vector<int> FaceCorners(int face) const;

  /// Returns the positions of all nodes in Gmsh's order: corners, edges, then inside the same again.
  std::vector<int> GmshOrder() const;

  /// Returns the positions of the nodes in Abaqus's order: corners, then the middles of edges; the
  /// nodes inside faces and cells are left out (serendipity elements). Order 1 or 2.
  std::vector<int> AbaqusOrder() const;

private:
  using Place = std::array<int, 3>;
  Place CornerPlace(int corner) const;
  int At(const Place& place) const;
  int Middle(const std::vector<int>& corners) const;
  void AddSquare(int low, int high, std::vector<int>& positions) const;

  int Dimension;
  int Order;
};
}
