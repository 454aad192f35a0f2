#include "TargetSize.h"

#include "Error.h"

#include <cmath>

namespace crossfield
{
double TargetSizes::At(const Point& place) const
{
  if (this->sizing != Sizing::Field)
  {
    return 1.0;
  }
  const double size = this->field(place);
  if (!(size > 0.0) || !std::isfinite(size))
  {
    throw Error("The target size at " + Describe(place) +
      " is not a positive number; give a size field that is positive in the whole domain.");
  }
  return size;
}
}
