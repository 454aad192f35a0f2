#include "DomainQueries.h"

#include "BoundaryCorners.h"
#include "Error.h"
#include "Segment.h"

#include <algorithm>
#include <limits>

namespace crossfield
{
int RayCrossing(const Point& point, const Point& from, const Point& to)
{
  const bool below = from.y() <= point.y();
  if (below == (to.y() <= point.y()))
  {
    return 0;
  }
  const double side = Cross(to - from, point - from);
  return below ? (side > 0.0 ? 1 : 0) : (side < 0.0 ? -1 : 0);
}

double SignedDistance(const Point& point, const PlanarDomain& domain)
{
  double distance = std::numeric_limits<double>::infinity();
  int winding = 0;
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point& from = loop[i];
      const Point& to = loop[(i + 1) % loop.size()];
      distance = std::min(distance, OffsetFromSegment(point, from, to).squaredNorm());
      winding += RayCrossing(point, from, to);
    }
  }
  // The loops wind once around a point of the domain and not at all around any other point.
  return winding > 0 ? std::sqrt(distance) : -std::sqrt(distance);
}

double DistanceAlongRay(const PlanarDomain& domain, const Point& from, const Point& direction)
{
  // Segments that start or end at `from` do not count.
  const double nearby = 1e-9 * domain.Diagonal();
  double clear = std::numeric_limits<double>::infinity();
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point start = loop[i] - from;
      const Point along = loop[(i + 1) % loop.size()] - loop[i];
      const double slope = Cross(direction, along);
      if (slope == 0.0)
      {
        continue;
      }
      const double distance = Cross(start, along) / slope;
      const double t = Cross(start, direction) / slope;
      if (distance > nearby && t >= 0.0 && t <= 1.0)
      {
        clear = std::min(clear, distance);
      }
    }
  }
  return std::isfinite(clear) ? clear : 0.0;
}

void RequireInside(const PlanarDomain& domain, const Configuration& configuration)
{
  const double reach = BoundaryReach * domain.Diagonal();
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    const Point& place = configuration[i].position;
    if (!place.allFinite())
    {
      throw Error("Row " + std::to_string(i + 1) +
        " of the singularities has a coordinate that is not a finite number; correct it.");
    }
    if (!(SignedDistance(place, domain) > -reach))
    {
      throw Error("The singularity " + std::to_string(i + 1) + " at " + Describe(place) +
        " lies outside the domain; move it inside.");
    }
  }
}
}
