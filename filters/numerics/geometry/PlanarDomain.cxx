#include "PlanarDomain.h"

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
}
