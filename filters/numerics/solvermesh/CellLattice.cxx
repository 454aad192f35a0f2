#include "CellLattice.h"

#include "Index.h"

#include <array>

namespace crossfield
{
namespace
{
using Positions = std::vector<int>;

// Corners in VTK's order, outward.
const std::vector<Positions> FacesOfQuad = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } };
const std::vector<Positions> FacesOfHexahedron = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
  { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };

// Orders of nodes, first of order 1. Corners, then edges, those inside faces and those inside.
const std::array<Positions, 3> Lines = { { { 0, 1 }, { 0, 2, 1 }, { 0, 3, 1, 2 } } };
const std::array<Positions, 3> Quads = { { { 0, 1, 3, 2 }, { 0, 2, 8, 6, 1, 5, 7, 3, 4 },
  { 0, 3, 15, 12, 1, 2, 7, 11, 14, 13, 8, 4, 5, 6, 10, 9 } } };
const Positions CubicQuadOfVtk = { 0, 3, 15, 12, 1, 2, 7, 11, 13, 14, 4, 8, 5, 6, 9, 10 };
const Positions Hexahedron = { 0, 1, 3, 2, 4, 5, 7, 6 };
const Positions HexahedronOfVtk = { 0, 2, 8, 6, 18, 20, 26, 24, 1, 5, 7, 3, 19, 23, 25, 21, 9, 11,
  17, 15, 12, 14, 10, 16, 4, 22, 13 };
const Positions HexahedronOfGmsh = { 0, 2, 8, 6, 18, 20, 26, 24, 1, 3, 9, 5, 11, 7, 17, 15, 19, 21,
  23, 25, 4, 10, 12, 14, 16, 22, 13 };
const Positions HexahedronOfExodus = { 0, 2, 8, 6, 18, 20, 26, 24, 1, 5, 7, 3, 9, 11, 17, 15, 19,
  23, 25, 21, 13, 4, 22, 12, 14, 10, 16 };
}

CellLattice::CellLattice(int dimension, int order)
  : Dimension(dimension)
  , Order(order)
{
}

int CellLattice::Corner(int corner) const
{
  const int along = this->Order + 1;
  const int around = corner % 4;
  const int column = around == 1 || around == 2 ? this->Order : 0;
  return column +
    along * ((around >= 2 ? this->Order : 0) + (corner >= 4 ? along * this->Order : 0));
}

int CellLattice::Transposed(int position) const
{
  const int along = this->Order + 1;
  const int layer = along * along;
  return position / along % along + along * (position % along) + position / layer * layer;
}

std::vector<int> CellLattice::FaceCorners(int face) const
{
  Positions positions;
  for (const int corner : (this->Dimension == 2 ? FacesOfQuad : FacesOfHexahedron)[face])
  {
    positions.push_back(this->Corner(corner));
  }
  return positions;
}

std::vector<int> CellLattice::Face(int face) const
{
  // Positions are linear in the indices.
  const Positions corners = this->FaceCorners(face);
  const int first = (corners[1] - corners[0]) / this->Order;
  const int second = (corners.back() - corners[0]) / this->Order; // that of a line is not used
  Positions positions;
  for (int j = 0; j <= (this->Dimension == 2 ? 0 : this->Order); ++j)
  {
    for (int i = 0; i <= this->Order; ++i)
    {
      positions.push_back(corners[0] + i * first + j * second);
    }
  }
  return positions;
}

std::vector<int> CellLattice::OrderFor(NodeOrder format) const
{
  const std::size_t order = Index(this->Order - 1);
  const bool isSerendipity = format == NodeOrder::Abaqus;
  Positions positions;
  if (this->Dimension == 1)
  {
    positions = Lines[order];
  }
  else if (this->Dimension == 2)
  {
    positions = format == NodeOrder::Vtk && this->Order == 3 ? CubicQuadOfVtk : Quads[order];
    positions.resize(isSerendipity ? Index(4 * this->Order) : positions.size());
  }
  else
  {
    positions = this->Order == 1    ? Hexahedron
      : format == NodeOrder::Gmsh   ? HexahedronOfGmsh
      : format == NodeOrder::Exodus ? HexahedronOfExodus
                                    : HexahedronOfVtk;
    constexpr std::size_t Serendipity = 20;
    positions.resize(isSerendipity && this->Order == 2 ? Serendipity : positions.size());
  }
  return positions;
}
}
