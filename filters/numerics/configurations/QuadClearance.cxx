#include "QuadClearance.h"

#include "LoopGap.h"

#include <algorithm>

namespace crossfield
{
double ClearanceForQuads(double quadSize)
{
  // The meshes of the gallery have their best shapes at 0.7 to 1.
  return 0.7 * quadSize;
}

ClearanceFactors ClearanceAtHoles(const PlanarDomain& domain, double quadSize, double quads)
{
  const double least = ClearanceForQuads(quadSize);
  ClearanceFactors factors;
  for (std::size_t l = 0; l < domain.loops.size(); ++l)
  {
    const double distance =
      l == 0 ? 0.0 : std::min(quads * quadSize, 0.5 * GapAround(domain, l) - quadSize);
    factors.emplace_back(domain.loops[l].size(), std::max(1.0, distance / least));
  }
  return factors;
}
}
