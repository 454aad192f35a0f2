#include "PairPlacement.h"

#include "DomainQueries.h"

#include <algorithm>

namespace crossfield
{
std::array<Point, 2> PositionsForPair(
  const FactoredDomain& domain, const Configuration& configuration)
{
  Point best = Point::Zero();
  double farthest = -1.0;
  for (const Point& vertex : domain.GetPotential()->GetTopology().mesh.points)
  {
    double distance = SignedDistance(vertex, domain.GetDomain());
    for (const Singularity& singularity : configuration)
    {
      distance = std::min(distance, (singularity.position - vertex).norm());
    }
    if (distance > farthest)
    {
      best = vertex;
      farthest = distance;
    }
  }
  const Point step(farthest / 3.0, 0.0);
  return { best - step, best + step };
}
}
