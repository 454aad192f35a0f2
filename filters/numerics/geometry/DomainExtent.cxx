#include "DomainExtent.h"

#include "Error.h"

#include <sstream>

namespace crossfield
{
void RequireExtent(double extent)
{
  if (extent != 0.0 && !(extent >= SmallestExtent && extent <= LargestExtent))
  {
    std::ostringstream text;
    text << "The domain has an extent of " << extent << ", beyond the limits of " << SmallestExtent
         << " and " << LargestExtent << "; give it in another unit of length.";
    throw Error(text.str());
  }
}
}
