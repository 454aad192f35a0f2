#include "TMesh.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
double TMesh::SideLength(const TPatch& face, std::size_t side) const
{
  double length = 0.0;
  for (const int h : face.sides[side])
  {
    length += this->arcs[static_cast<std::size_t>(h / 2)].length;
  }
  return length;
}

double TMesh::Mismatch() const
{
  double largest = 0.0;
  for (const TPatch& face : this->faces)
  {
    for (std::size_t side = 0; side < 2; ++side)
    {
      largest = std::max(
        largest, std::abs(this->SideLength(face, side) - this->SideLength(face, side + 2)));
    }
  }
  return largest;
}
}
