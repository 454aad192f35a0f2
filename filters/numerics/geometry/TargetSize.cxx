#include "TargetSize.h"

#include "Error.h"

#include <cmath>

namespace crossfield
{
double TargetSize(const SizeFunction& sizes, const Point& place)
{
  const double size = sizes(place);
  if (!(size > 0.0) || !std::isfinite(size))
  {
    throw Error("The target size at " + Describe(place) +
      " is not a positive number; give a size field that is positive in the whole domain.");
  }
  return size;
}
}
