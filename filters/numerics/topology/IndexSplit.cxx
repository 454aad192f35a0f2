#include "IndexSplit.h"

#include "BoundaryCorners.h"
#include "DomainQueries.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace crossfield
{
namespace
{
/// Returns the vector from a position to the nearest point of the boundary or other singularity.
Point ToNearest(const PlanarDomain& domain, const Configuration& configuration, std::size_t row)
{
  const Point& place = configuration[row].position;
  Point nearest(domain.Diagonal(), 0.0);
  const auto consider = [&](const Point& other)
  { nearest = (other - place).norm() < nearest.norm() ? Point(other - place) : nearest; };
  for (const Loop& loop : domain.loops)
  {
    for (std::size_t i = 0; i < loop.size(); ++i)
    {
      const Point along = loop[(i + 1) % loop.size()] - loop[i];
      const double t = (place - loop[i]).dot(along) / along.squaredNorm();
      consider(loop[i] + std::min(1.0, std::max(0.0, t)) * along);
    }
  }
  for (std::size_t other = 0; other < configuration.size(); ++other)
  {
    if (other != row)
    {
      consider(configuration[other].position);
    }
  }
  return nearest;
}
}

SplitConfiguration SplitIndices(
  const PlanarDomain& domain, const Configuration& configuration, double distance)
{
  // Parts of two neighbours that are both split remain apart.
  constexpr double LargestRadius = 0.3; // relative to the distance to whatever is nearest
  SplitConfiguration result;
  for (std::size_t row = 0; row < configuration.size(); ++row)
  {
    const Singularity& whole = configuration[row];
    const int count = std::abs(whole.quarterIndex);
    if (count < 2 || SignedDistance(whole.position, domain) <= BoundaryReach * domain.Diagonal())
    {
      result.singularities.push_back(whole);
      continue;
    }
    const Point nearest = ToNearest(domain, configuration, row);
    const double radius =
      std::min(0.5 * distance / std::sin(Pi / count), LargestRadius * nearest.norm());
    const double first = std::atan2(nearest.y(), nearest.x()) + 0.5 * Pi;
    const int sign = whole.quarterIndex > 0 ? 1 : -1;
    for (int i = 0; i < count; ++i)
    {
      const double angle = first + 2.0 * Pi * i / count;
      result.singularities.push_back(
        { whole.position + radius * Point(std::cos(angle), std::sin(angle)), sign, 0.0 });
    }
    result.events.push_back("The singularity at " + Describe(whole.position) +
      " of quarter index " + std::to_string(whole.quarterIndex) + " was split into " +
      std::to_string(count) + " of index " + std::to_string(sign) + ".");
  }
  return result;
}
}
