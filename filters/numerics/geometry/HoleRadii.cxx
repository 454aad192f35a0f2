#include "HoleRadii.h"

#include "BoundaryCorners.h"
#include "DomainQueries.h"

#include <algorithm>
#include <limits>

namespace crossfield
{
namespace
{
double DistanceToNearest(const Configuration& configuration, std::size_t row)
{
  double next = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    if (i != row)
    {
      next = std::min(next, (configuration[i].position - configuration[row].position).norm());
    }
  }
  return next;
}
}

double LargestHoleRadius(
  const PlanarDomain& domain, const Configuration& configuration, std::size_t row)
{
  return std::min(SignedDistance(configuration[row].position, domain),
    0.5 * DistanceToNearest(configuration, row));
}

double DefaultRadius(
  const PlanarDomain& domain, const Configuration& configuration, std::size_t row, double meshSize)
{
  const Point& place = configuration[row].position;
  if (!place.allFinite())
  {
    return meshSize; // refused by DrillHoles
  }
  const double inside = SignedDistance(place, domain);
  const double next = DistanceToNearest(configuration, row);
  const double distance = std::min(inside, next);
  return inside > BoundaryReach * domain.Diagonal() && distance > 0.0
    ? std::min(meshSize, distance / 3.0)
    : meshSize;
}

Configuration WithDefaultRadii(
  const PlanarDomain& domain, const Configuration& configuration, double meshSize)
{
  Configuration result = configuration;
  for (std::size_t i = 0; i < result.size(); ++i)
  {
    if (result[i].radius == 0.0)
    {
      result[i].radius = DefaultRadius(domain, configuration, i, meshSize);
    }
  }
  return result;
}
}
