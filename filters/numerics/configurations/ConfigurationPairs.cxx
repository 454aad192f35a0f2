#include "ConfigurationPairs.h"

#include "ConfigurationSpread.h"
#include "DomainQueries.h"

#include <array>
#include <cstddef>
#include <limits>
#include <optional>

namespace crossfield
{
namespace
{
/// Returns the two closest singularities that satisfy a predicate, if they are closer than a
/// distance; otherwise two equal numbers.
template <class Predicate>
std::array<std::size_t, 2> NearestTwo(
  const Configuration& configuration, double distance, Predicate predicate)
{
  std::array<std::size_t, 2> nearest = { 0, 0 };
  for (std::size_t i = 0; i < configuration.size(); ++i)
  {
    for (std::size_t j = 0; j < i; ++j)
    {
      const double separation = (configuration[i].position - configuration[j].position).norm();
      if (separation < distance && predicate(configuration[i], configuration[j]))
      {
        distance = separation;
        nearest = { i, j };
      }
    }
  }
  return nearest;
}

void Erase(Configuration& configuration, std::size_t member)
{
  configuration.erase(configuration.begin() + static_cast<std::ptrdiff_t>(member));
}
}

void CancelOpposites(Configuration& configuration, double distance)
{
  const auto opposite = [](const Singularity& a, const Singularity& b)
  { return a.quarterIndex * b.quarterIndex == -1; };
  for (;;)
  {
    const auto [later, earlier] = NearestTwo(configuration, distance, opposite);
    if (later == earlier)
    {
      return;
    }
    Erase(configuration, later);
    Erase(configuration, earlier);
  }
}

bool MergeNearest(const PlanarDomain& domain, Configuration& configuration)
{
  const auto equal = [](const Singularity& a, const Singularity& b)
  { return a.quarterIndex == b.quarterIndex; };
  const auto [later, earlier] =
    NearestTwo(configuration, std::numeric_limits<double>::infinity(), equal);
  if (later == earlier)
  {
    return false;
  }
  Singularity merged = configuration[earlier];
  merged.position = 0.5 * (configuration[earlier].position + configuration[later].position);
  merged.quarterIndex *= 2;
  if (!(SignedDistance(merged.position, domain) > 0.0))
  {
    return false;
  }
  configuration[earlier] = merged;
  Erase(configuration, later);
  return true;
}

bool AddPair(const PlanarDomain& domain, Configuration& configuration)
{
  for (const int quarterIndex : { 1, -1 })
  {
    const std::optional<Point> position = FindFreePlace(domain, configuration);
    if (!position)
    {
      return false;
    }
    configuration.push_back({ *position, quarterIndex, 0.0 });
  }
  return true;
}
}
