#include "LoopGap.h"

#include "SegmentSearch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crossfield
{
double GapAround(const PlanarDomain& domain, std::size_t loop)
{
  // The nearest points of two polygons are a vertex of one and a point of the other.
  PlanarDomain own;
  own.loops = { domain.loops[loop] };
  PlanarDomain others = domain;
  others.loops.erase(others.loops.begin() + static_cast<std::ptrdiff_t>(loop));
  double squared = std::numeric_limits<double>::infinity();
  const auto regard = [&](const PlanarDomain& sides, const PlanarDomain& vertices)
  {
    const SegmentSearch search(sides);
    for (const Loop& polygon : vertices.loops)
    {
      for (const Point& vertex : polygon)
      {
        squared = std::min(squared, search.Find(vertex).squaredDistance);
      }
    }
  };
  if (!others.loops.empty())
  {
    regard(own, others);
    regard(others, own);
  }
  return std::sqrt(squared);
}
}
