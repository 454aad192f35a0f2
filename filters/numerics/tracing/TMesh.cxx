#include "TMesh.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
double TMesh::SideLength(const TPatch& patch, std::size_t side) const
{
  double length = 0.0;
  for (const int h : patch.sides[side])
  {
    length += this->arcs[h / 2].length;
  }
  return length;
}

double TMesh::Mismatch() const
{
  double largest = 0.0;
  for (const TPatch& patch : this->patches)
  {
    for (std::size_t side = 0; side < 2; ++side)
    {
      largest = std::max(
        largest, std::abs(this->SideLength(patch, side) - this->SideLength(patch, side + 2)));
    }
  }
  return largest;
}
}
