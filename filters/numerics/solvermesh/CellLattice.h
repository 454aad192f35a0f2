#pragma once

#include <vector>

namespace crossfield
{
/// How a format orders the nodes of cells and faces. All begin with the corners in VTK's order.
enum class NodeOrder
{
  Vtk,    ///< Edges of quads in the direction of increasing index.
  Gmsh,   ///< Edges around the cell, then inside the same again.
  Abaqus, ///< The nodes inside faces and cells are left out (serendipity elements).
  Exodus  ///< Upright edges before those of the top; prisms are hexahedra.
};

/// Positions in the lattice of nodes of a line, quad or hexahedron (SolverMesh.h), and their order in the
/// formats. Lines and quads have order 1 to 3, hexahedra 1 or 2.
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

  /// Returns the positions of the corners of a face, around it and outwards.
  std::vector<int> FaceCorners(int face) const;

  /// Returns the positions of the nodes in the order of a format; Abaqus has none of order 3.
  std::vector<int> OrderFor(NodeOrder format) const;

private:
  int Dimension;
  int Order;
};
}
