#include "SizedChoice.h"

#include "FitToQuads.h"
#include "OptimizerReport.h"
#include "Segment.h"
#include "SizeForm.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace crossfield
{
namespace
{
AutomaticConfiguration ChoiceOf(const SizedConfiguration& found, const AutomaticOptions& options)
{
  AutomaticConfiguration choice;
  choice.singularities = found.singularities;
  choice.corners = options.proposal.corners;
  choice.optimum.configuration = found.singularities;
  choice.optimum.sizeSpread = found.spread;
  choice.optimum.converged = true; // no move of the search lowers its objective
  choice.optimum.reason = "They were searched for the target sizes.";
  choice.events = { DescribeChoice(found.singularities) +
    " Start: search for the target sizes; the standard deviation of the logarithm of size over target size is " +
    FormatShort(found.spread) + "." };
  return choice;
}

/// Returns the options of the search, which refer to the domain and the options.
SizeSearchOptions SearchOptions(const PlanarDomain& domain, const AutomaticOptions& options)
{
  // The logarithm of a size and that of its multiples need the same singularities. The search uses the multiple by
  // a power of two with which sizes change on as many quads as it can resolve, so that meshes that are
  // refined by halving all sizes have the same singularities.
  constexpr double MostQuads = 1000.0;
  const double requested = ResolveQuadSize(domain, options);
  const auto sizeFor = [&options](double quadSize) -> SizeFunction
  {
    return [quadSize, &options](const Point& place)
    { return quadSize * options.optimizer.sizes.At(place); };
  };
  double quadSize = requested;
  while (domain.Area() / (quadSize * quadSize) > MostQuads)
  {
    quadSize *= 2.0;
  }
  while (quadSize > requested && CountGradedQuads(domain, sizeFor(0.5 * quadSize)) <= MostQuads)
  {
    quadSize *= 0.5;
  }
  SizeSearchOptions search;
  search.corners = options.proposal.corners;
  search.cornerAngle = options.proposal.cornerAngle;
  search.given = options.proposal.given;
  search.size = sizeFor(quadSize);
  const ClearanceFactors& factors = options.optimizer.clearanceFactors;
  if (!factors.empty()) // layers need rows without singularities
  {
    const double clearance = RequestedClearance(domain, options);
    search.isFree = [&domain, &factors, clearance](const Point& place)
    {
      for (std::size_t l = 0; l < domain.loops.size(); ++l)
      {
        const Loop& loop = domain.loops[l];
        for (std::size_t i = 0; i < loop.size(); ++i)
        {
          const double distance = clearance * FactorAt(factors, l, i);
          if (FactorAt(factors, l, i) > 1.0 &&
            OffsetFromSegment(place, loop[i], loop[(i + 1) % loop.size()]).norm() < distance)
          {
            return false;
          }
        }
      }
      return true;
    };
  }
  return search;
}
}

double SpreadOfGiven(const PlanarDomain& domain, const AutomaticOptions& options)
{
  return SpreadOfSizes(domain, SearchOptions(domain, options));
}

std::optional<AutomaticConfiguration> ChooseForSizes(
  const PlanarDomain& domain, const AutomaticOptions& options, const Progress& progress)
{
  const std::vector<SizedConfiguration> found =
    SearchForSizes(domain, SearchOptions(domain, options), progress);
  if (found.empty())
  {
    return std::nullopt;
  }
  AutomaticConfiguration best = ChoiceOf(found.front(), options);
  for (std::size_t i = 1; i < std::min(found.size(), options.configurations); ++i)
  {
    best.others.push_back(ChoiceOf(found[i], options));
    best.others.back().rank = static_cast<int>(i);
  }
  return best;
}

std::optional<SizedConfiguration> AddPairsForSizes(
  const PlanarDomain& domain, const AutomaticOptions& options, const Progress& progress)
{
  const auto given = options.proposal.given.size();
  const auto most = given + 2 * static_cast<std::size_t>(options.optimizer.pairs);
  std::optional<SizedConfiguration> best;
  for (const SizedConfiguration& found :
    SearchForSizes(domain, SearchOptions(domain, options), progress))
  {
    int sum = 0; // of those that were added
    for (std::size_t i = given; i < found.singularities.size(); ++i)
    {
      sum += found.singularities[i].quarterIndex;
    }
    if (sum == 0 && found.singularities.size() <= most && (!best || found.spread < best->spread))
    {
      best = found;
    }
  }
  return best;
}
}
