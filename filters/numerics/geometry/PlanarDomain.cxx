#include "PlanarDomain.h"

#include "CanonicalFrame.h"

namespace crossfield
{
double PlanarDomain::Area() const
{
  double area = 0.0;
  for (const Loop& loop : this->loops)
  {
    area += SignedArea(loop);
  }
  return area;
}

double PlanarDomain::Diagonal() const
{
  return BoundingDiagonal(CanonicalFrame(this->loops).ToFrame(this->loops));
}
}
