#include "QuadRequest.h"

#include <algorithm>

namespace crossfield
{
bool IsSizingFree(const QuadRequest& request)
{
  return !request.sizing && request.layers.empty() &&
    std::none_of(request.prescribed.begin(), request.prescribed.end(),
      [](const SidePrescription& one) { return one.isGraded; });
}
}
