#include "ConfigurationCheck.h"

#include "BoundarySingularities.h"
#include "DomainQueries.h"
#include "HolonomyCheck.h"
#include "Index.h"
#include "RegionRequests.h"
#include "RegionSides.h"

#include <string>
#include <utility>

namespace crossfield
{
namespace
{
/// Returns a sentence about corners that were capped; `uncapped` is the required sum without this.
std::string DescribeCaps(std::size_t corners, int uncapped)
{
  return std::to_string(corners) +
    (corners == 1 ? " very sharp corner counts as an ordinary one"
                  : " very sharp corners count as ordinary ones") +
    ", with one quad; without this the sum is " + std::to_string(uncapped) +
    " (CapCorners, --no-cap-corners).";
}

/// Counts with singularities on the boundary as corners with chosen indices.
PoincareHopfCount CountWithBoundary(const PlanarDomain& domain, const Configuration& configuration,
  std::vector<CornerChoice> choices, double cornerAngle)
{
  int interior = TotalQuarters(configuration);
  for (const CornerChoice& choice : BoundaryChoices(domain, configuration))
  {
    choices.push_back(choice);
    interior -= choice.quarterIndex;
  }
  return CountQuarters(
    InsertBoundarySingularities(domain, configuration).loops, interior, cornerAngle, choices);
}

/// Adds up the counts of regions.
void Add(const PoincareHopfCount& part, PoincareHopfCount& sum)
{
  sum.eulerCharacteristic += part.eulerCharacteristic;
  sum.valence += part.valence;
  sum.tangentTurning += part.tangentTurning;
  sum.requiredInteriorQuarters += part.requiredInteriorQuarters;
  sum.givenInteriorQuarters += part.givenInteriorQuarters;
  sum.corners.insert(sum.corners.end(), part.corners.begin(), part.corners.end());
}

/// Returns a sentence about the nodes of regions that are irregular nodes of the mesh.
std::string DescribeNodes(const RegionSet& set, const RegionRequests& requests)
{
  std::string places;
  int count = 0;
  for (std::size_t n = 0; n < set.nodes.size(); ++n)
  {
    const int index = IndexAt(set.nodes[n], requests.nodeCorners[n]);
    if (index != 0 && !set.nodes[n].isOnBoundary)
    {
      places += (count++ > 0 ? ", " : "") + Describe(set.nodes[n].place) + " (" +
        std::to_string(4 - index) + " quads)";
    }
  }
  return count == 0 ? std::string()
    : count == 1    ? " The node of regions at " + places + " is an irregular node of the mesh."
                    : " The nodes of regions at " + places + " are irregular nodes of the mesh.";
}
}

ConfigurationCheck CheckConfiguration(const PlanarDomain& domain,
  const Configuration& configuration, std::vector<CornerChoice> choices,
  const CheckOptions& options, const Progress& progress)
{
  ConfigurationCheck result;
  const std::size_t given = choices.size();
  const PoincareHopfCount uncapped = CountQuarters(domain.loops, 0, options.cornerAngle, choices);
  if (options.cap)
  {
    choices = CapCorners(uncapped, choices);
  }
  progress.Report(0.1);
  RequireInside(domain, configuration);
  result.count = CountWithBoundary(domain, configuration, choices, options.cornerAngle);
  result.consistent = result.count.Consistent();
  if (result.consistent && options.holonomy)
  {
    result.holonomyDefects =
      HolonomyDefects(domain, configuration, choices, progress.Part(0.1, 1.0));
  }
  result.reason = ConsistencyReason(result.count, result.holonomyDefects);
  if (choices.size() > given)
  {
    result.reason += " " + DescribeCaps(choices.size() - given, uncapped.requiredInteriorQuarters);
  }
  return result;
}

int RequiredSum(const PlanarDomain& domain, const Configuration& configuration,
  const std::vector<CornerChoice>& choices, const CheckOptions& options)
{
  const PoincareHopfCount count = CountWithBoundary(domain, configuration,
    options.cap ? CapCorners(CountQuarters(domain.loops, 0, options.cornerAngle, choices), choices)
                : choices,
    options.cornerAngle);
  return count.requiredInteriorQuarters + TotalQuarters(configuration) -
    count.givenInteriorQuarters;
}

ConfigurationCheck CheckRegions(const RegionSet& set, const Configuration& configuration,
  const std::vector<CornerChoice>& choices, const CheckOptions& options, const Progress& progress)
{
  std::vector<DomainPart> parts;
  for (const Region& region : set.regions)
  {
    parts.push_back({ region.domain, {}, {} });
  }
  QuadRequest request;
  request.singularities = configuration;
  request.corners = choices;
  const RegionRequests requests = SplitForRegions(set, parts, request);
  ConfigurationCheck result;
  result.consistent = true;
  for (std::size_t r = 0; r < parts.size(); ++r)
  {
    const QuadRequest& own = requests.ofRegions[r].request;
    const auto size = static_cast<double>(parts.size());
    const auto number = static_cast<double>(r);
    const ConfigurationCheck found =
      CheckConfiguration(parts[r].domain, own.singularities.value_or(Configuration()), own.corners,
        options, progress.Part(number / size, (number + 1.0) / size));
    Add(found.count, result.count);
    result.holonomyDefects.insert(
      result.holonomyDefects.end(), found.holonomyDefects.begin(), found.holonomyDefects.end());
    result.regions.push_back({ set.regions[r].material, found.count.requiredInteriorQuarters,
      found.count.givenInteriorQuarters, 0 });
    if (!found.consistent)
    {
      result.reason +=
        (result.consistent ? "" : " ") + DescribeRegion(set, r) + ": " + found.reason;
      result.consistent = false;
    }
  }
  if (result.consistent)
  {
    result.reason = parts.size() == 1
      ? "The quarter indices add up to the sum that the corners require."
      : "The quarter indices in each of the " + std::to_string(parts.size()) +
        " regions add up to the sum that its corners require.";
  }
  result.reason += DescribeNodes(set, requests);
  return result;
}
}
