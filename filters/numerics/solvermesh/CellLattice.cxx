#include "CellLattice.h"

#include "Index.h"

#include <algorithm>

namespace crossfield
{
namespace
{
using Corners = std::vector<int>;

// Corners in VTK's order, outward.
const std::vector<Corners> FacesOfQuad = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 } };
const std::vector<Corners> FacesOfHexahedron = { { 0, 3, 2, 1 }, { 4, 5, 6, 7 }, { 0, 1, 5, 4 },
  { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 3, 0, 4, 7 } };
const std::vector<Corners> GmshEdges = { { 0, 1 }, { 0, 3 }, { 0, 4 }, { 1, 2 }, { 1, 5 }, { 2, 3 },
  { 2, 6 }, { 3, 7 }, { 4, 5 }, { 4, 7 }, { 5, 6 }, { 6, 7 } };
const std::vector<Corners> GmshFaces = { { 0, 3, 2, 1 }, { 0, 1, 5, 4 }, { 0, 4, 7, 3 },
  { 1, 2, 6, 5 }, { 2, 3, 7, 6 }, { 4, 5, 6, 7 } };
const std::vector<Corners> AbaqusEdges = { { 0, 1 }, { 1, 2 }, { 2, 3 }, { 3, 0 }, { 4, 5 },
  { 5, 6 }, { 6, 7 }, { 7, 4 }, { 0, 4 }, { 1, 5 }, { 2, 6 }, { 3, 7 } };
}

CellLattice::CellLattice(int dimension, int order)
  : Dimension(dimension)
  , Order(order)
{
}

CellLattice::Place CellLattice::CornerPlace(int corner) const
{
  const int around = corner % 4;
  return { around == 1 || around == 2 ? this->Order : 0, around >= 2 ? this->Order : 0,
    corner >= 4 ? this->Order : 0 };
}

int CellLattice::At(const Place& place) const
{
  const int along = this->Order + 1;
  return place[0] + along * (place[1] + along * place[2]);
}

int CellLattice::Corner(int corner) const
{
  return this->At(this->CornerPlace(corner));
}

int CellLattice::Transposed(int position) const
{
  const int along = this->Order + 1;
  return this->At({ position / along % along, position % along, position / (along * along) });
}

std::vector<int> CellLattice::FaceCorners(int face) const
{
  std::vector<int> positions;
  for (const int corner : (this->Dimension == 2 ? FacesOfQuad : FacesOfHexahedron)[Index(face)])
  {
    positions.push_back(this->Corner(corner));
  }
  return positions;
}

std::vector<int> CellLattice::Face(int face) const
{
  const Corners& corners = (this->Dimension == 2 ? FacesOfQuad : FacesOfHexahedron)[Index(face)];
  const Place origin = this->CornerPlace(corners[0]);
  const Place first = this->CornerPlace(corners[1]);
  const Place second = this->CornerPlace(corners.back()); // that of a line is not used
  std::vector<int> positions;
  for (int j = 0; j <= (this->Dimension == 2 ? 0 : this->Order); ++j)
  {
    for (int i = 0; i <= this->Order; ++i)
    {
      Place place{};
      for (std::size_t c = 0; c < place.size(); ++c)
      {
        place[c] =
          origin[c] + (i * (first[c] - origin[c]) + j * (second[c] - origin[c])) / this->Order;
      }
      positions.push_back(this->At(place));
    }
  }
  return positions;
}

int CellLattice::Middle(const std::vector<int>& corners) const
{
  Place sum{};
  for (const int corner : corners)
  {
    const Place place = this->CornerPlace(corner);
    for (std::size_t c = 0; c < sum.size(); ++c)
    {
      sum[c] += place[c];
    }
  }
  const int count = static_cast<int>(corners.size());
  return this->At({ sum[0] / count, sum[1] / count, sum[2] / count });
}

void CellLattice::AddSquare(int low, int high, std::vector<int>& positions) const
{
  if (low > high)
  {
    return;
  }
  positions.push_back(this->At({ low, low, 0 }));
  if (low == high)
  {
    return;
  }
  for (const Place& corner :
    { Place{ high, low, 0 }, Place{ high, high, 0 }, Place{ low, high, 0 } })
  {
    positions.push_back(this->At(corner));
  }
  for (int edge = 0; edge < 4; ++edge)
  {
    for (int k = low + 1; k < high; ++k)
    {
      const int back = low + high - k;
      const std::array<Place, 4> places = { { { k, low, 0 }, { high, k, 0 }, { back, high, 0 },
        { low, back, 0 } } };
      positions.push_back(this->At(places[Index(edge)]));
    }
  }
  this->AddSquare(low + 1, high - 1, positions);
}

std::vector<int> CellLattice::OrderOfLine(NodeOrder order) const
{
  std::vector<int> positions;
  for (int k = 0; k <= this->Order; ++k)
  {
    positions.push_back(k);
  }
  if (order != NodeOrder::EnSight)
  {
    std::rotate(positions.begin() + 1, positions.end() - 1, positions.end()); // both ends first
  }
  return positions;
}

std::vector<int> CellLattice::OrderOfQuad(NodeOrder order) const
{
  const int p = this->Order;
  std::vector<int> positions;
  this->AddSquare(0, p, positions);
  if (order == NodeOrder::Vtk && p == 3)
  {
    std::swap(positions[8], positions[9]); // the edge from corner 3 to corner 2
    std::swap(positions[10], positions[11]);
    std::swap(positions[14], positions[15]); // inside, row by row
  }
  else if (order == NodeOrder::Abaqus || order == NodeOrder::EnSight)
  {
    positions.resize(Index(4 * p));
  }
  return positions;
}

std::vector<int> CellLattice::OrderOfHexahedron(NodeOrder order) const
{
  std::vector<int> positions;
  for (int corner = 0; corner < 8; ++corner)
  {
    positions.push_back(this->Corner(corner));
  }
  if (this->Order == 1)
  {
    return positions;
  }
  const bool isGmsh = order == NodeOrder::Gmsh;
  for (const Corners& edge : isGmsh ? GmshEdges : AbaqusEdges)
  {
    positions.push_back(this->Middle(edge));
  }
  if (isGmsh)
  {
    for (const Corners& face : GmshFaces)
    {
      positions.push_back(this->Middle(face));
    }
    positions.push_back(this->At({ 1, 1, 1 }));
  }
  else if (order == NodeOrder::Vtk)
  {
    // Middles of the faces with least and largest first, second and third index, then the middle.
    positions.insert(positions.end(), { 12, 14, 10, 16, 4, 22, 13 });
  }
  else if (order == NodeOrder::Exodus)
  {
    std::rotate(positions.begin() + 12, positions.begin() + 16, positions.end());
    // The middle, then those of the faces with least and largest third, first and second index.
    positions.insert(positions.end(), { 13, 4, 22, 12, 14, 10, 16 });
  }
  return positions;
}

std::vector<int> CellLattice::OrderFor(NodeOrder order) const
{
  return this->Dimension == 1 ? this->OrderOfLine(order)
    : this->Dimension == 2    ? this->OrderOfQuad(order)
                              : this->OrderOfHexahedron(order);
}
}
