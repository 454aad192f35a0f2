#include "QuadRequest.h"

#include "SizeSearch.h"

#include <cmath>

namespace crossfield
{
bool HasRequestedCount(const QuadRequest& request, const QuadResult& quads)
{
  const auto count = static_cast<double>(quads.mesh.quads.size());
  return request.quadSize != 0.0 || std::abs(count / request.quadCount - 1.0) <= CountTolerance;
}
}
