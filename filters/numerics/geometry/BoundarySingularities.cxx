#include "BoundarySingularities.h"

#include "DomainQueries.h"

#include <cmath>

namespace crossfield
{
PlanarDomain InsertBoundarySingularities(
  const PlanarDomain& domain, const Configuration& configuration)
{
  PlanarDomain result = domain;
  const double reach = BoundaryReach * domain.Diagonal();
  for (const Singularity& singularity : configuration)
  {
    const Point& place = singularity.position;
    for (Loop& loop : result.loops)
    {
      for (std::size_t i = 0; i < loop.size(); ++i)
      {
        const Point& from = loop[i];
        const Point along = loop[(i + 1) % loop.size()] - from;
        const double t = (place - from).dot(along) / along.squaredNorm();
        const double end = reach / along.norm();
        if (t > end && t < 1.0 - end && (from + t * along - place).norm() <= reach)
        {
          loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + 1, from + t * along);
          break;
        }
      }
    }
  }
  return result;
}

bool IsOnBoundary(const PlanarDomain& domain, const Point& place)
{
  return std::abs(SignedDistance(place, domain)) <= BoundaryReach * domain.Diagonal();
}

std::vector<CornerChoice> BoundaryChoices(
  const PlanarDomain& domain, const Configuration& configuration)
{
  std::vector<CornerChoice> choices;
  for (const Singularity& singularity : configuration)
  {
    if (IsOnBoundary(domain, singularity.position))
    {
      choices.push_back({ singularity.position, singularity.quarterIndex });
    }
  }
  return choices;
}
}
