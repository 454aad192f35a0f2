#include "QuadRequest.h"

#include "SizeSearch.h"

#include <algorithm>
#include <cmath>

namespace crossfield
{
bool IsSizingFree(const QuadRequest& request)
{
  return !request.sizing && !request.singularities && request.layers.empty() &&
    std::none_of(request.prescribed.begin(), request.prescribed.end(),
      [](const SidePrescription& one) { return one.isGraded; });
}

bool HasRequestedCount(const QuadRequest& request, const QuadResult& quads)
{
  const auto count = static_cast<double>(quads.mesh.quads.size());
  return request.quadSize != 0.0 || std::abs(count / request.quadCount - 1.0) <= CountTolerance;
}
}
