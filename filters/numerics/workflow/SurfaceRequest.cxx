#include "SurfaceRequest.h"

#include <algorithm>

namespace crossfield
{
bool SurfaceRequest::HasSizes() const
{
  return !this->sizes.IsEmpty() ||
    std::any_of(this->sides.begin(), this->sides.end(),
      [](const SurfaceSideRequest& one) { return one.size > 0.0; });
}
}
